/* SPDX-License-Identifier: Apache-2.0 */
/* A floor of planks, each with the grain of another tree; planks lie along v. */
surface planks(
    float width = 4, depth = 3;             /* of the floor, metres */
    float plank = .14;                      /* metres */
    color light = color(.56, .36, .19), dark = color(.33, .18, .08);)
{
    float across = u * width / plank;
    float number = floor(across);
    float along = v * depth + 7 * cellnoise(number);
    float grain = 9 * noise(point(12 * (across - number), .8 * along, 3 * number));
    float ring = smoothstep(.1, .9, .5 + .5 * sin(6.2832 * (grain + 3 * (across - number))));
    float gap = smoothstep(0, .03, min(across - number, 1 - across + number));
    Oi = Os;
    Ci = Os * gap * (.8 + .4 * cellnoise(number + 31)) * mix(dark, light, ring) *
         diffuse(faceforward(normalize(N), I));
}
