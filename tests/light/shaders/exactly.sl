/* SPDX-License-Identifier: Apache-2.0
   Says what it is told, in or out of range. */
surface exactly(float opacity = 1;)
{
    Oi = opacity;
    Ci = Cs;
}
