/* SPDX-License-Identifier: Apache-2.0
   Lumps of many sizes, half of them out and half in, by up to height: stones, dough, the moon. The
   largest are 1/frequency wide, in object space; each finer layer is roughness times as high as the
   one before. */
displacement lumpy(float height = .1, frequency = 2, octaves = 6, roughness = .5;)
{
    point p = frequency * transform("object", P);
    float lump = 0, size = 1, sizes = 0, k;
    for (k = 0; k < octaves; k += 1) {
        lump += size * (2 * (float noise(p)) - 1);
        sizes += size;
        p = 2 * p + vector "current" (.19, .53, .89);
        size *= roughness;
    }
    P += height * lump / max(sizes, 1) * normalize(N);
    N = calculatenormal(P);
}
