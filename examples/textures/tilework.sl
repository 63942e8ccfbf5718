/* SPDX-License-Identifier: Apache-2.0
   A picture to be made a texture of: a square of glazed tiles, two by two, a star in each. */
surface tilework(color glaze = color (.06, .16, .32); color star = color (.85, .78, .6);
                 color joint = color (.32, .3, .28);)
{
    float x = mod(2 * s, 1) - .5, y = mod(2 * t, 1) - .5;
    float odd = mod(floor(2 * s) + floor(2 * t), 2);
    float rim = max(abs(x), abs(y)), leaf = abs(x) + abs(y), petal = abs(x * y);
    float inside = 1 - smoothstep(.0095, .0125, petal) * smoothstep(.16, .18, leaf);
    float shade = .85 + .3 * noise(24 * s, 24 * t);
    color field = mix(glaze, star, odd);
    color figure = mix(star, glaze, odd);

    Oi = 1;
    Ci = shade * mix(mix(field, figure, inside * (1 - smoothstep(.40, .42, rim))), joint,
                     smoothstep(.475, .485, rim));
}
