/* SPDX-License-Identifier: Apache-2.0 */
#include "adaptation.h"
#include "choices.h"

/* Scales luminance by one factor: to a white that is given, the brightest pixel, or a mean. */
filter linear_scale(
    float L_white = 0;            /* luminance that becomes 1 [0, as `reference` says, or above,
                                     cd/m^2] */
    string reference = "maximum"; /* "maximum" of the picture becomes 1, its "mean" .5, or its
                                     geometric mean, "logmean", .18 [one of these] */
    float gain = 1;               /* times this [0 up] */)
{
    checkchoice("reference", reference, "maximum|mean|logmean", "maximum");
    float white = L_white;
    if (white <= 0) {
        if (reference == "mean")
            white = meanluminance() / .5;
        else if (reference == "logmean")
            white = exp(meanlogluminance(0, 1e-4)) / .18;
        else
            white = greatestluminance();
    }

    float scale = white > 0 ? gain / white : 0;
    float x, y;
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1)
            setimage("Ci", x, y, photometric(color image("Cs", x, y)) * scale);
}
