/* SPDX-License-Identifier: Apache-2.0 */
/* Hexagons by the nearest of two shifted lattices. */
surface hex_tiles(float Ka = 1, Kd = .5, Ks = .3, roughness = .05, radius = .1, grout = .008;
                  color tilecolor = color(.55, 0, 0); color groutcolor = .5; float vary = .15)
{
    float w = radius * 1.7320508, ss, tt, best = 1000, id = 0, k;
    for (k = 0; k < 2; k += 1) {
        float cx = (floor(s / w - k * .5) + .5 + k * .5) * w;
        float cy = (floor(t / (3 * radius) - k * .5) + .5 + k * .5) * 3 * radius;
        float dx = abs(s - cx), dy = abs(t - cy);
        float d = max(dx, dx * .5 + dy * .8660254);
        if (d < best) { best = d; id = cx * 13 + cy * 57; ss = s - cx; tt = t - cy; }
    }
    float tile = 1 - smoothstep(w / 2 - 2 * grout, w / 2 - grout, best);
    normal Nf = faceforward(normalize(N), I);
    color C = mix(groutcolor, tilecolor * (1 - vary * float cellnoise(id * 100)), tile);
    Oi = Os;
    Ci = Os * (C * (Ka * ambient() + Kd * diffuse(Nf)) + tile * Ks * specular(Nf, -normalize(I), roughness)) + 0 * (ss + tt);
}
