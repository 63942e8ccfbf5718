/* SPDX-License-Identifier: Apache-2.0
   Lumps of many sizes, half of them out and half in, by up to height: stones, dough, the moon. The
   largest are 1/frequency wide, in object space; each finer layer is roughness times as high as the
   one before. */
displacement lumpy(
    float height = .1;    /* how far the highest lumps stand out, in current space [any, length] */
    float frequency = 2;  /* largest lumps to a length of 1, in object space [0 up, 1/length] */
    float octaves = 6;    /* sizes of lumps, each half as large as the one before [1 to 12] */
    float roughness = .5; /* how high each is, times the one before [0 to 1] */)
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
