/* SPDX-License-Identifier: Apache-2.0
   Convolves the picture with a kernel: one by name and width, or weights. A pixel alone becomes the
   kernel's picture; beyond the border, the border holds. */
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

filter convolve(
    string kernel = "gaussian"; /* box, triangle, gaussian, catmull-rom or lanczos */
    float width = 5;            /* all of it, pixels; a gaussian deviates by a quarter */
    float xwidth = 0;           /* the same across; 0: width */
    float ywidth = 0;           /* and down */
    float weights[] = {0};      /* instead: weights by rows from the top, as they are */
    float columns = 0;          /* how many of them a row has; 0: no weights */
    float normalize = 0;        /* 1: weights are divided by their sum */)
{
    float x, y, i, j;

    if (columns > 0) {
        float rows = floor(arraylength(weights) / columns);
        float left = floor((columns - 1) / 2), above = floor((rows - 1) / 2);
        float sum = 0;
        for (i = 0; i < rows * columns; i += 1)
            sum += weights[i];
        float scale = normalize != 0 && sum != 0 ? 1 / sum : 1;
        for (y = 0; y < ysize; y += 1)
            for (x = 0; x < xsize; x += 1) {
                color c = 0;
                for (j = 0; j < rows; j += 1)
                    for (i = 0; i < columns; i += 1)
                        c += weights[j * columns + i] *
                             color image("Cs", x + (left - i), y + (above - j));
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
