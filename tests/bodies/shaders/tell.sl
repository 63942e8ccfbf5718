/* SPDX-License-Identifier: Apache-2.0
   Tells what a point is: its (u,v), its normals, or its place in the object. */
surface tell(float what = 0;)
{
    Oi = 1;
    if (what == 0)
        Ci = color (u, v, 0);
    else if (what == 1)
        Ci = .5 + .25 * color (zcomp(normalize(N)) + ycomp(normalize(Ng)),
                               xcomp(normalize(N)) + zcomp(normalize(dPdu)), 0);
    else
        Ci = .5 + .1 * color (xcomp(transform("object", P)), zcomp(transform("object", P)), 0);
}
