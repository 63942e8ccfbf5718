/* SPDX-License-Identifier: Apache-2.0 */
surface a(point p = point "shader"(1, 2, 3); point q = p + point "world"(0, 0, 1);
          vector w = 2 * vector "world"(1, 0, 0); color c = color "hsv"(.5, .5, .5) * .5;)
{
    Ci = c * xcomp(p) * ycomp(q) * xcomp(w);
    Oi = Os;
}
