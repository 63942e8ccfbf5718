/* SPDX-License-Identifier: Apache-2.0
   A surface that is not there: light passes, and nothing is added. */
surface null()
{
    Oi = 0;
    Ci = 0;
}
