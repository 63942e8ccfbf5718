/* SPDX-License-Identifier: Apache-2.0
   Dents of many sizes, pressed in by up to depth, as sheet metal has them after some years. The
   largest are 1/frequency wide, in object space; sharpness above 1 leaves the sheet plain between
   the deeper ones. */
displacement dented(float depth = .05, frequency = 2, octaves = 5, sharpness = 3;)
{
    point p = frequency * transform("object", P);
    float dent = 0, size = 1, sizes = 0, k;
    for (k = 0; k < octaves; k += 1) {
        dent += size * abs(2 * float noise(p) - 1);
        sizes += size;
        p = 2 * p + vector "current" (.37, .71, .13);
        size *= .5;
    }
    P -= depth * pow(dent / max(sizes, 1), sharpness) * normalize(N);
    N = calculatenormal(P);
}
