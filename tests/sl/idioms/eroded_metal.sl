/* SPDX-License-Identifier: Apache-2.0 */
/* Metal eaten away where turbulence is low. */
surface eroded_metal(float Ks = .5, Ka = 1, roughness = .2, Km = .3; float octaves = 5)
{
    point W = 4 * transform("object", P);
    float size = 1, chaos = 0, i;
    for (i = 0; i < octaves; i = i + 1) {
        chaos += abs(.5 - noise(size * W)) / size;
        size *= 2.0;
    }
    float hole = step(Km, chaos);
    normal Nf = faceforward(normalize(N), I);
    Oi = Os * hole;
    Ci = Oi * Cs * (Ka * ambient() + Ks * specular(Nf, -normalize(I), roughness));
}
