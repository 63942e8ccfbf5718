/* SPDX-License-Identifier: Apache-2.0 */
/* Dents of fractal depth: displacement with a recomputed normal. */
displacement
dented(float Km = 1.0, power = 3, octaves = 6)
{
    float size = 1, magnitude = 0, i;
    point P2 = transform("shader", P);
    for (i = 0; i < octaves; i += 1) {
        magnitude += abs(.5 - noise(P2 * size)) / size;
        size *= 2;
    }
    magnitude = pow(magnitude, power) * Km;
    P -= magnitude * normalize(N);
    N = calculatenormal(P);
}
