/* SPDX-License-Identifier: Apache-2.0 */
filter double(float factor = 2; color tint = 1;)
{
    float x, y;
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1)
            setimage("Ci", x, y, factor * tint * image("Cs", x, y));
}
