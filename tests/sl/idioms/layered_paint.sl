/* SPDX-License-Identifier: Apache-2.0 */
/* Layers with alpha, each a macro: the style of shader handbooks. */
#define blend(a, b, x) ((a) * (1 - (x)) + (b) * (x))
#define pulse(a, b, fuzz, x) (smoothstep((a) - (fuzz), (a), (x)) - smoothstep((b) - (fuzz), (b), (x)))
#define repeat(x, freq) (mod((x) * (freq), 1.0))
#define whichtile(x, freq) (floor((x) * (freq)))
#define udn(x, lo, hi) (smoothstep(.25, .75, noise(x)) * ((hi) - (lo)) + (lo))
surface layered_paint(float Ka = 1, Kd = 1, fuzz = .02, freq = 4)
{
    color surface_color, layer_color;
    color surface_opac, layer_opac;
    float ss, tt, row, col, r, theta, angle, in_out, d;
    point c1, c2;

    surface_color = Cs;
    surface_opac = Os;
    col = whichtile(s, freq);
    row = whichtile(t, freq);
    ss = repeat(s, freq);
    tt = repeat(t, freq);

    /* a disk */
    layer_color = color (udn(row * 12.289, .2, .9), .2, udn(col * 5.31, .3, .8));
    c1 = point (.5 + .2 * (noise(row, col) - .5), .5, 0);
    d = distance(c1, point (ss, tt, 0));
    layer_opac = 1 - smoothstep(.25 - fuzz, .25, d);
    surface_color = blend(surface_color, layer_color, layer_opac);

    /* petals */
    layer_color = color "hsv" (.15, .9, .9);
    r = 2 * sqrt((ss - .5) * (ss - .5) + (tt - .5) * (tt - .5));
    theta = atan(tt - .5, ss - .5);
    angle = .5 + .5 * cos(5 * theta);
    in_out = 1 - step(.2 + .3 * angle, r);
    layer_opac = in_out * pulse(.05, .95, fuzz, ss);
    surface_color = blend(surface_color, layer_color, layer_opac);

    Oi = surface_opac;
    Ci = surface_opac * surface_color * (Ka * ambient() + Kd * diffuse(faceforward(normalize(N), I)));
}
