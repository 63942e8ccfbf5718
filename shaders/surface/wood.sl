/* SPDX-License-Identifier: Apache-2.0
   Wood: rings about the line through c0 and c1, in shader space, in the surface's colour and a
   darker one. */
surface wood(
    float Ka = 1;                        /* share of ambient light that is sent on [0 to 1] */
    float Kd = .6;                       /* albedo, times the colour of the wood [0 to 1] */
    float Ks = .4;                       /* strength of the highlights [0 to 1] */
    float roughness = .1;                /* their width; the exponent is 8 over it [.001 to 1] */
    color specularcolor = 1;             /* their colour, channel by channel [0 to 1] */
    float grain = 5;                     /* how many rings there are [0 up, 1/length] */
    float swirl = .25;                   /* how far they leave the circle [0 up, rings] */
    float swirlfreq = 1;                 /* how soon they do [0 up, 1/length] */
    color darkcolor = color(.5, .4, .3); /* of late wood, times the surface's colour [0 to 1] */
    point c0 = point "shader" (0, 0, 0); /* on the line that rings are about [anywhere] */
    point c1 = point "shader" (0, 0, 1); /* there too, apart from c0 [anywhere] */)
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
