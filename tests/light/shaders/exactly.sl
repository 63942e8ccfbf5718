/* SPDX-License-Identifier: Apache-2.0
   Black, and as opaque as it is told to be, in or out of range. */
surface exactly(float opacity = 1;)
{
    Oi = opacity;
    Ci = 0;
}
