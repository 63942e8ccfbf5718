/* SPDX-License-Identifier: Apache-2.0 */
/* Bricks in running bond, with mortar and a colour for each brick. */
#define BRICKWIDTH .25
#define BRICKHEIGHT .08
#define MORTAR .01
#define BM (BRICKWIDTH + MORTAR)
#define BH (BRICKHEIGHT + MORTAR)
surface running_bricks(
    uniform float Ka = 1; uniform float Kd = .75;
    uniform color brickcolor = color "rgb" (.6, .1, .14);
    uniform color mortarcolor = color "rgb" (.6, .6, .6);
    uniform float jagged = .006, variation = .3;
    )
{
    float ss = s + jagged * (2 * float noise(s * 40, t * 40) - 1);
    float tt = t + jagged * (2 * float noise(s * 40 + 7, t * 40) - 1);
    float row = floor(tt / BH);
    if (mod(row, 2) == 1)
        ss += BM / 2;
    float column = floor(ss / BM);
    float inBrick = (ss - column * BM > MORTAR) && (tt - row * BH > MORTAR);
    float shade = 1 + variation * (float cellnoise(column, row) - .5);
    normal Nf = faceforward(normalize(N), I);
    Oi = Os;
    Ci = Os * mix(mortarcolor, brickcolor * shade, inBrick) * (Ka * ambient() + Kd * diffuse(Nf));
}
