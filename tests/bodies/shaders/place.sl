/* SPDX-License-Identifier: Apache-2.0
   Tells where it is seen: red = x in its world + 8, green = 1. */
surface place()
{
    Oi = 1;
    Ci = color (xcomp(transform("world", P)) + 8, 1, 0);
}
