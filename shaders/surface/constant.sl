/* SPDX-License-Identifier: Apache-2.0
   The surface's own colour, lit or not. */
surface constant()
{
    Oi = Os;
    Ci = Os * Cs;
}
