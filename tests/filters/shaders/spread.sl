/* SPDX-License-Identifier: Apache-2.0 */
/* The mean of samples, taken one by one. */
filter spread(float samples = 4;)
{
    float x, y, k;
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            color sum = 0;
            for (k = 0; k < samples; k += 1)
                sum += image("samples", x, y, "sample", k);
            setimage("Ci", x, y, sum / samples);
        }
}
