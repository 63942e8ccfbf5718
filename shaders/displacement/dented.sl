/* SPDX-License-Identifier: Apache-2.0
   Dents of many sizes, pressed in by up to depth, as sheet metal has them after some years. The
   largest are 1/frequency wide, in object space; sharpness above 1 leaves the sheet plain between
   the deeper ones. */
displacement dented(
    float depth = .05;   /* how far the deepest dents go in, in current space [any, length] */
    float frequency = 2; /* largest dents to a length of 1, in object space [0 up, 1/length] */
    float octaves = 5;   /* sizes of dents, each half as large as the one before [1 to 12] */
    float sharpness = 3; /* above 1 the sheet stays plain between the deeper ones [above 0 to
                            20] */)
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
