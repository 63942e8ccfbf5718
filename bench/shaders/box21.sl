/* SPDX-License-Identifier: Apache-2.0
   The mean of 21 x 21 pixels. */
filter box21(float radius = 10) {
    float x, y, i, j;
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            color sum = 0;
            for (j = -radius; j <= radius; j += 1)
                for (i = -radius; i <= radius; i += 1)
                    sum += image("Cs", x + i, y + j);
            setimage("Ci", x, y, sum / ((2 * radius + 1) * (2 * radius + 1)));
        }
}
