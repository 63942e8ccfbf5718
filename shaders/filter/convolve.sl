/* SPDX-License-Identifier: Apache-2.0 */
#include "kernels.h"

#define WIDEST 256 /* pixels that a kernel may reach to either side */

/* Weights at -radius to radius, of sum 1; gives the radius. */
float weightsacross(string kernel; float width; output float weights[])
{
    float radius = min(floor(max(width, 1) / 2 + .5), WIDEST), i, sum = 0;

    for (i = -radius; i <= radius; i += 1) {
        weights[i + radius] = kernelweight(kernel, i, max(width, 1));
        sum += weights[i + radius];
    }
    for (i = 0; i <= 2 * radius; i += 1)
        weights[i] /= sum;
    return radius;
}

/* Convolves the picture with a kernel, given by name and width or as weights.
   A pixel alone becomes the kernel's picture; beyond the border, the border holds. */
filter convolve(
    string kernel = "gaussian"; /* its form ["box", "triangle", "gaussian", "catmull-rom" or
                                   "lanczos"] */
    float width = 5;            /* all of it; a gaussian deviates by a quarter [0 to 512, pixels] */
    float xwidth = 0;           /* the same across [0, as width says, to 512, pixels] */
    float ywidth = 0;           /* and down [0, as width says, to 512, pixels] */
    float weights3[9] = {0};    /* instead: weights of 3 by 3 pixels, by rows from the top [any] */
    float weights5[25] = {0};   /* the same, of 5 by 5 [any] */
    float weights7[49] = {0};   /* of 7 by 7 [any] */
    float normalize = 0;        /* whether weights are divided by their sum [0 or 1] */)
{
    float x, y, i, j;
    float weights[49];
    float size = 0, sum = 0;

    for (i = 0; i < 49; i += 1) {
        weights[i] = weights7[i];
        size = weights7[i] != 0 ? 7 : size;
    }
    for (i = 0; i < 25 && size != 7; i += 1) {
        weights[i] = weights5[i];
        size = weights5[i] != 0 ? 5 : size;
    }
    for (i = 0; i < 9 && size == 0; i += 1)
        size = weights3[i] != 0 ? 3 : size;
    if (size == 3)
        for (i = 0; i < 9; i += 1)
            weights[i] = weights3[i];

    if (size > 0) {
        float middle = (size - 1) / 2;
        for (i = 0; i < size * size; i += 1)
            sum += weights[i];
        float scale = normalize != 0 && sum != 0 ? 1 / sum : 1;
        for (y = 0; y < ysize; y += 1)
            for (x = 0; x < xsize; x += 1) {
                color c = 0;
                for (j = 0; j < size; j += 1)
                    for (i = 0; i < size; i += 1)
                        c += weights[j * size + i] *
                             color image("Cs", x + (middle - i), y + (middle - j));
                setimage("Ci", x, y, c * scale);
            }
    } else if (isakernel(kernel) != 0) {
        float across[2 * WIDEST + 1], down[2 * WIDEST + 1];
        float xradius = weightsacross(kernel, xwidth > 0 ? xwidth : width, across);
        float yradius = weightsacross(kernel, ywidth > 0 ? ywidth : width, down);
        setsize("convolve.across", xsize, ysize);
        for (y = 0; y < ysize; y += 1)
            for (x = 0; x < xsize; x += 1) {
                color c = 0;
                for (i = -xradius; i <= xradius; i += 1)
                    c += across[i + xradius] * color image("Cs", x + i, y);
                setimage("convolve.across", x, y, c);
            }
        for (y = 0; y < ysize; y += 1)
            for (x = 0; x < xsize; x += 1) {
                color c = 0;
                for (j = -yradius; j <= yradius; j += 1)
                    c += down[j + yradius] * color image("convolve.across", x, y + j);
                setimage("Ci", x, y, c);
            }
    }
}
