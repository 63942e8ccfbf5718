/* SPDX-License-Identifier: Apache-2.0 */
#include "kernels.h"

/* How many pixels of a line a kernel of that span may touch. */
float touched(float span) { return ceil(span) + 2; }

/* The weights with which a line's pixels become one of another length: in column x, those of the
   pixels that touch its pixel x, and behind them which pixel is the first of these. The line begins
   at pixel `from` and is `length` pixels long. */
void makeweights(string map, kernel; float from, length, newlength, span)
{
    float count = touched(span);
    float x, k;

    setsize(map, newlength, count + 1);
    for (x = 0; x < newlength; x += 1) {
        float middle = from + (x + .5) * length / newlength - .5;
        float first = ceil(middle - (span + 1) / 2), sum = 0;
        for (k = 0; k < count; k += 1)
            sum += kernelweight(kernel, first + k - middle, span);
        for (k = 0; k < count; k += 1)
            setimage(map, x, k, kernelweight(kernel, first + k - middle, span) / sum);
        setimage(map, x, count, first);
    }
}

/* The span, in pixels of a line, of a kernel of that width in pixels of the coarser picture. */
float spanof(string kernel; float width, length, newlength)
{
    float ratio = length / newlength;
    return (width > 0 ? width : usualwidth(kernel)) * (kernel == "box" ? ratio : max(ratio, 1));
}

/* Makes a map anew from a part of another, across and then down. */
void resample(string from, to, kernel;
              float left, top, across, down, newacross, newdown, width, negative)
{
    extern float ysize;
    float xspan = spanof(kernel, width, across, newacross);
    float yspan = spanof(kernel, width, down, newdown);
    float xcount = touched(xspan), ycount = touched(yspan);
    float x, y, k;

    makeweights("crop_resample.xweights", kernel, left, across, newacross, xspan);
    makeweights("crop_resample.yweights", kernel, top, down, newdown, yspan);
    setsize("crop_resample.across", newacross, ysize);
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < newacross; x += 1) {
            float first = image("crop_resample.xweights", x, xcount);
            color c = 0;
            for (k = 0; k < xcount; k += 1)
                c += float image("crop_resample.xweights", x, k) *
                     color image(from, first + k, y, "filter", "nearest");
            setimage("crop_resample.across", x, y, c);
        }
    for (y = 0; y < newdown; y += 1)
        for (x = 0; x < newacross; x += 1) {
            float first = image("crop_resample.yweights", y, ycount);
            color c = 0;
            for (k = 0; k < ycount; k += 1)
                c += float image("crop_resample.yweights", y, k) *
                     color image("crop_resample.across", x, first + k);
            setimage(to, x, y, negative != 0 ? c : max(c, color 0));
        }
}

/* Cuts a part out of the picture and makes it anew in another size, across and then down. */
filter crop_resample(
    float crop[4] = {0, 1, 0, 1};  /* left, right, top and bottom, as parts of the picture [0 to
                                      1] */
    float width = 0;               /* of what comes out [0, in proportion to the height, or 1 up,
                                      pixels] */
    float height = 0;              /* the same; both 0: the part as it is [0 or 1 up, pixels] */
    string kernel = "catmull-rom"; /* its form ["box", "triangle", "gaussian", "catmull-rom" or
                                      "lanczos"] */
    float kernelwidth = 0;         /* its width, of the coarser picture [0, the usual, or above,
                                      pixels] */
    float negative = 0;            /* whether what kernels with negative lobes bring below 0 is
                                      kept [0 or 1] */)
{
    float x, y;
    float left = clamp(ceil(crop[0] * xsize - 1e-3), 0, xsize - 1);
    float right = clamp(ceil(crop[1] * xsize - 1e-3), left + 1, xsize);
    float top = clamp(ceil(crop[2] * ysize - 1e-3), 0, ysize - 1);
    float bottom = clamp(ceil(crop[3] * ysize - 1e-3), top + 1, ysize);
    float across = right - left, down = bottom - top;
    float newacross = across, newdown = down;

    if (width > 0)
        newacross = max(floor(width + .5), 1);
    if (height > 0)
        newdown = max(floor(height + .5), 1);
    if (width > 0 && height <= 0)
        newdown = max(floor(newacross * down / across + .5), 1);
    if (height > 0 && width <= 0)
        newacross = max(floor(newdown * across / down + .5), 1);

    setsize("crop_resample.opacity", xsize, ysize);
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1)
            setimage("crop_resample.opacity", x, y, color image("Oi", x, y));
    setsize("Ci", newacross, newdown);
    setsize("Oi", newacross, newdown);
    if (newacross == across && newdown == down) {
        for (y = 0; y < down; y += 1)
            for (x = 0; x < across; x += 1) {
                setimage("Ci", x, y, color image("Cs", x + left, y + top));
                setimage("Oi", x, y, color image("crop_resample.opacity", x + left, y + top));
            }
    } else {
        string used = kernel;
        if (isakernel(kernel) == 0)
            used = "catmull-rom";
        resample("Cs", "Ci", used, left, top, across, down, newacross, newdown, kernelwidth,
                 negative);
        resample("crop_resample.opacity", "Oi", used, left, top, across, down, newacross,
                 newdown, kernelwidth, 0);
    }
}
