/* SPDX-License-Identifier: Apache-2.0 */
#include "adaptation.h"

#define WIDEST 32 /* pixels that weights reach to either side */
#define MOST 12   /* scales; weights of more reach no farther */

/* Weights of a Gaussian at -radius to radius, three standard deviations at most; gives the radius. */
float gaussianweights(float deviation; output float weights[])
{
    float radius = min(floor(3 * deviation + 1), WIDEST), i, sum = 0;

    for (i = -radius; i <= radius; i += 1) {
        weights[i + radius] = exp(-i * i / (2 * deviation * deviation));
        sum += weights[i + radius];
    }
    for (i = 0; i <= 2 * radius; i += 1)
        weights[i] /= sum;
    return radius;
}

/* Tone reproduction: a key value for the picture's middle, highlights rolled off, as in photography.
   local = 1 dodges and burns: each pixel adapts to as much of its neighbourhood as is alike.
   Gives display values. E. Reinhard, M. Stark, P. Shirley, J. Ferwerda, "Photographic tone
   reproduction for digital images", SIGGRAPH 2002. */
filter reinhard02(
    float key = .18;       /* value of the geometric mean, before highlights are rolled off [0 to
                              1] */
    float L_white = 0;     /* luminance that becomes 1 if local is 0 [0, the greatest, or above,
                              cd/m^2] */
    float local = 0;       /* whether it dodges and burns [0 or 1] */
    float sharpness = 8;   /* the paper's phi: how much edges tell, against noise [1 to 15] */
    float threshold = .05; /* contrast of centre and surround that ends a neighbourhood [0 to 1] */
    float scales = 8;      /* neighbourhoods that are tried; each is 1.6 times as wide [1 to 12] */)
{
    float middle = exp(meanlogluminance(0, 1e-4));
    float toscaled = key / middle;
    float x, y, i, number;

    if (local == 0) {
        float white = (L_white > 0 ? L_white : greatestluminance()) * toscaled;
        float burn = white > 0 ? 1 / (white * white) : 0;
        for (y = 0; y < ysize; y += 1)
            for (x = 0; x < xsize; x += 1) {
                color c = image("Cs", x, y);
                float scaled = totalluminance(c) * toscaled;
                float rolled = (1 + scaled * burn) / (1 + scaled);
                setimage("Ci", x, y, photometric(c) * (toscaled * rolled));
            }
    } else {
        float weights[65];
        float size = 1;

        setsize("reinhard02.scaled", xsize, ysize);
        setsize("reinhard02.across", xsize, ysize);
        setsize("reinhard02.centre", xsize, ysize);
        setsize("reinhard02.surround", xsize, ysize);
        setsize("reinhard02.adapted", xsize, ysize);
        setsize("reinhard02.ended", xsize, ysize);
        for (y = 0; y < ysize; y += 1)
            for (x = 0; x < xsize; x += 1)
                setimage("reinhard02.scaled", x, y,
                         totalluminance(color image("Cs", x, y)) * toscaled);

        /* The Gaussian of size s is exp(-(r / (.35 s))^2): a deviation of s/4. What surrounds one
           size is the centre of the next. */
        for (number = 0; number <= min(scales, MOST); number += 1) {
            float radius = gaussianweights(size / 4, weights);
            for (y = 0; y < ysize; y += 1)
                for (x = 0; x < xsize; x += 1) {
                    float sum = 0;
                    for (i = -radius; i <= radius; i += 1)
                        sum += weights[i + radius] * float image("reinhard02.scaled", x + i, y);
                    setimage("reinhard02.across", x, y, sum);
                }
            for (y = 0; y < ysize; y += 1)
                for (x = 0; x < xsize; x += 1) {
                    float sum = 0;
                    for (i = -radius; i <= radius; i += 1)
                        sum += weights[i + radius] * float image("reinhard02.across", x, y + i);
                    setimage("reinhard02.surround", x, y, sum);
                }
            /* A neighbourhood grows while centre and surround are alike. */
            float edge = pow(2, sharpness) * key * 1.6 * 1.6 / (size * size);
            for (y = 0; y < ysize; y += 1)
                for (x = 0; x < xsize; x += 1) {
                    float centre = image("reinhard02.centre", x, y);
                    float surround = image("reinhard02.surround", x, y);
                    float ended = image("reinhard02.ended", x, y);
                    if (number > 0 && ended == 0) {
                        float contrast = abs(centre - surround) / (edge + centre);
                        if (contrast < threshold || number == 1)
                            setimage("reinhard02.adapted", x, y, centre);
                        if (contrast >= threshold)
                            setimage("reinhard02.ended", x, y, 1);
                    }
                    setimage("reinhard02.centre", x, y, surround);
                }
            size *= 1.6;
        }

        for (y = 0; y < ysize; y += 1)
            for (x = 0; x < xsize; x += 1) {
                float adapted = image("reinhard02.adapted", x, y);
                setimage("Ci", x, y,
                         photometric(color image("Cs", x, y)) * (toscaled / (1 + adapted)));
            }
    }
}
