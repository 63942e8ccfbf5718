/* SPDX-License-Identifier: Apache-2.0
   A surface that moves its points as "lumps" does, and tells where it is, and its normals. */
surface selflumps(float by = .15, freq = 3, what = 0;)
{
    normal n = normalize(ntransform("object", N));
    point p = transform("object", P) + by * (float noise(freq * transform("object", P))) * vector n;
    P = transform("object", "current", p);
    N = calculatenormal(P);
    Oi = 1;
    point o = transform("object", P);
    normal m = normalize(N);
    Ci = what == 0 ? color (xcomp(o), ycomp(o), 0) / 4 + .5
                   : color (xcomp(m), ycomp(m), 0) / 4 + .5;
}
