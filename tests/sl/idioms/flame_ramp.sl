/* SPDX-License-Identifier: Apache-2.0 */
/* Fire by a table of colours and noise that rises with the frame. */
surface flame_ramp(uniform float frame = 1, chaosscale = 1, chaosoffset = 0, octaves = 8, flameheight = 1, flameamplitude = .5)
{
    color ramp[5] = {color(0, 0, 0), color(.5, .05, 0), color(1, .4, 0), color(1, .9, .3), color(1, 1, .9)};
    point PP = point (xcomp(P), ycomp(P) - .05 * frame, zcomp(P) - .02 * frame);
    float size = 1, sum = 0;
    uniform float i;
    for (i = 0; i < octaves; i += 1) {
        sum += abs(.5 - noise(4 * PP * size)) / size;
        size *= 2;
    }
    float heat = clamp(chaosscale * sum + chaosoffset + flameamplitude * (flameheight - t), 0, .999);
    float index = floor(heat * 4);
    Oi = smoothstep(0, .3, heat);
    Ci = Oi * mix(ramp[index], ramp[index + 1], heat * 4 - index);
}
