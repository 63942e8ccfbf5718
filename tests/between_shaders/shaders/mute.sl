/* SPDX-License-Identifier: Apache-2.0 */
/* Reads nothing. */
surface mute()
{
    Oi = 1;
    Ci = 1;
}
