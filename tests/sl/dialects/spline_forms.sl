/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    color c = spline(s, color(0, 0, 0), color(.1, .1, .1), color(.5, .2, .3), color(1, 1, 1));
    color d = spline(s, (0, 0, 0), (1, 1, 1), (.5, .5, .5), (1, 0, 0), (0, 0, 0));
    float arr[5] = {0, 0, .5, 1, 1};
    float f = spline(s, arr);
    float g = spline("linear", s, arr);
    float h = float spline("bezier", s, 0, 1, 2, 3);
    color ca[4] = {color(1, 1, 1), color(0, 0, 0), 1, 0};
    c += spline("catmull-rom", s, ca);
    float i = spline("solvelinear", s, 0, 0, .5, 1, 1);
    float j = spline("solvecatmull-rom", s, arr);
    point p = spline(s, P, P, P, P);
    Ci = c + d + f + g + h + i + j + xcomp(p);
    Oi = Os;
    float k = solvespline(s, 0, 0, 1, 1);
}
