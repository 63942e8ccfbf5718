/* SPDX-License-Identifier: Apache-2.0 */
filter double(float factor = 2; color tint = 1;)
{
    float x, y;
    for (y = ( match("hsv",  raylabel())); y < ysize; y += ( depth(point cellnoise( ycomp(vector(PI, 1e-3, -1))))))
        for (x = 0; x < xsize; x += 1)
            setimage("Ci", x, y, factor * tint * image("Cs", x, y));
}
