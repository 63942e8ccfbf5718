/* SPDX-License-Identifier: Apache-2.0 */
/* Quarter circles, turned by chance in each cell. */
surface truchet_maze(float freq = 8, width = .12, fuzz = .03; color line = color(.1, .1, .4), paper = 1)
{
    float ss = s * freq, tt = t * freq;
    float column = floor(ss), row = floor(tt);
    ss -= column;
    tt -= row;
    if (float cellnoise(column, row) > .5)
        ss = 1 - ss;
    float a = sqrt(ss * ss + tt * tt), b = sqrt((1 - ss) * (1 - ss) + (1 - tt) * (1 - tt));
    float d = min(abs(a - .5), abs(b - .5));
    float on = 1 - smoothstep(width / 2 - fuzz, width / 2 + fuzz, d);
    Oi = Os;
    Ci = Os * mix(paper, line, on);
}
