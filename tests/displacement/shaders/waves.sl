/* SPDX-License-Identifier: Apache-2.0
   Waves across the object's x and y, along its normals; of which the test knows the form. */
displacement waves(float by = .1, freq = 6;)
{
    point o = transform("object", P);
    normal n = normalize(ntransform("object", N));
    o += by * sin(freq * xcomp(o)) * cos(freq * ycomp(o)) * vector n;
    P = transform("object", "current", o);
    N = calculatenormal(P);
}
