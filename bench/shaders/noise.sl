/* SPDX-License-Identifier: Apache-2.0
   One noise, grey. */
surface noise()
{
    Oi = Os;
    Ci = float noise(8 * P);
}
