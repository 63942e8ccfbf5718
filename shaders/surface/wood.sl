/* SPDX-License-Identifier: Apache-2.0
   Wood: rings about the line through c0 and c1, in shader space, in the surface's colour and a
   darker one. */
surface wood(float Ka = 1, Kd = .6, Ks = .4; /* shares of ambient, diffuse, specular light */
             float roughness = .1;           /* of the highlights */
             color specularcolor = 1;
             float grain = 5;                /* rings per unit of length */
             float swirl = .25;              /* how far they leave the circle, in rings */
             float swirlfreq = 1;            /* how soon */
             color darkcolor = color(.5, .4, .3); /* late wood, times the surface's colour */
             point c0 = point "shader" (0, 0, 0), c1 = point "shader" (0, 0, 1);)
{
    normal Nf = faceforward(normalize(N), I);
    point q = transform("shader", P), a = transform("shader", c0);
    vector axis = transform("shader", c1) - a;
    vector off = q - a;
    if (axis . axis > 0)
        off -= axis * ((off . axis) / (axis . axis));
    float ring = grain * length(off) + swirl * (2 * float noise(swirlfreq * q) - 1);
    float late = smoothstep(.2, .8, ring - floor(ring)) *
                 (1 - smoothstep(.85, 1, ring - floor(ring)));
    float fibre = .8 + .4 * float noise(grain * 8 * (off + a));
    color tone = Cs * mix(color(1, 1, 1), darkcolor, late) * fibre;
    Oi = Os;
    Ci = Os * (tone * (Ka * ambient() + Kd * diffuse(Nf)) +
               specularcolor * Ks * specular(Nf, -normalize(I), roughness));
}
