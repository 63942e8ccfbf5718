/* SPDX-License-Identifier: Apache-2.0
   Lumps of noise in the object's own space, as large there whatever stretches it. */
displacement lumps(float by = .15, freq = 3;)
{
    normal n = normalize(ntransform("object", N));
    point p = transform("object", P) + by * (float noise(freq * transform("object", P))) * vector n;
    P = transform("object", "current", p);
    N = calculatenormal(P);
}
