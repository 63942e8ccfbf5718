/* SPDX-License-Identifier: Apache-2.0
   Tells where it is in its object, or its normals, as "selflumps" does. */
surface tellplace(float what = 0;)
{
    Oi = 1;
    point o = transform("object", P);
    normal m = normalize(what == 1 ? N : Ng);
    Ci = what == 0 ? color (xcomp(o), ycomp(o), 0) / 4 + .5
                   : color (xcomp(m), ycomp(m), 0) / 4 + .5;
}
