/* SPDX-License-Identifier: Apache-2.0 */
/* Stars on the inside of a sphere: cells with a bright point in few of them. */
surface night_stars(float frequency = 30, threshold = .96, intensity = 3;
                    color space = color(0, 0, .01);)
{
    vector dir = normalize(vtransform("world", I));
    point cell = point (floor(xcomp(dir) * frequency), floor(ycomp(dir) * frequency), floor(zcomp(dir) * frequency));
    float chance = float cellnoise(cell);
    vector jitter = vector cellnoise(cell + 17) * .6 + .2;
    point centre = cell + jitter;
    float d = distance(centre, point(dir * frequency));
    float bright = 0;
    if (chance > threshold)
        bright = intensity * (1 - smoothstep(0, .2, d)) * (chance - threshold) / (1 - threshold);
    Oi = 1;
    Ci = space + bright * mix(color(1, .8, .6), color(.7, .8, 1), float cellnoise(cell + 3));
}
