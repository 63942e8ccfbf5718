/* SPDX-License-Identifier: Apache-2.0
   Tells the normals of "bumps" by itself, as "tellplace" tells N. */
surface tellbumps()
{
    normal m = normalize(normalize(N) + .4 * sin(8 * xcomp(P)) * vector "current" (1, 0, 0));
    Oi = 1;
    Ci = color (xcomp(m), ycomp(m), 0) / 4 + .5;
}
