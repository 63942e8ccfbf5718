/* SPDX-License-Identifier: Apache-2.0 */
filter makes()
{
    float x, y;
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1)
            setimage("mine", x, y, x);
}
