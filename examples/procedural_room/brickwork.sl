/* SPDX-License-Identifier: Apache-2.0 */
/* A wall of bricks in mortar, every brick of another fire; u runs along the wall, v up. */
surface brickwork(
    float width = 4, height = 2.6;          /* of the wall, metres */
    float brick = .25, course = .083;       /* from joint to joint, metres */
    float joint = .012;                     /* of mortar, metres */
    color fired = color(.42, .16, .10), mortar = color(.55, .53, .48);)
{
    float along = u * width / brick, up = v * height / course;
    float row = floor(up);
    along += .5 * mod(row, 2);
    float number = floor(along);
    float fromJoint = min(min(along - number, 1 - along + number) * brick,
                          min(up - row, 1 - up + row) * course);
    float face = smoothstep(.5 * joint, .8 * joint, fromJoint);
    float fire = .6 + .8 * cellnoise(number, row);
    color clay = fired * fire * (.85 + .3 * noise(80 * u * width, 80 * v * height));
    Oi = Os;
    Ci = Os * mix(mortar, clay, face) * diffuse(faceforward(normalize(N), I));
}
