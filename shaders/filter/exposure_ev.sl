/* SPDX-License-Identifier: Apache-2.0 */
#include "adaptation.h"

/* Exposes the picture as a camera does, by EV, aperture, shutter and ISO; 1 saturates the sensor.
   With aperture N, shutter t and speed S: value = L q S t / (78 N^2), L in cd/m^2, q = .65
   (ISO 12232); 2^EV = N^2/t. The meter chooses N^2/t = L S/K, K = 12.5 cd/m^2 (ISO 2720). */
filter exposure_ev(
    float EV = -1000;       /* exposure value of aperture and shutter [-20 to 30; -1000: from
                               those two] */
    float aperture = 0;     /* f-number [.5 to 64; 0: as EV or the meter says] */
    float shutter = 0;      /* time; without it or aperture or EV: the meter's choice [0 up,
                               seconds] */
    float ISO = 100;        /* speed of the sensor [above 0] */
    float compensation = 0; /* how much brighter [any, EV] */
    float K = 12.5;         /* the meter's constant [above 0, cd/m^2] */
    float q = .65;          /* of the lens: what share of light it passes, with its angles [0 to
                               1] */)
{
    float apertureovertime; /* N^2/t, 1/s */
    float x, y;

    if (EV > -1000)
        apertureovertime = pow(2, EV);
    else if (aperture > 0 && shutter > 0)
        apertureovertime = aperture * aperture / shutter;
    else
        apertureovertime = meanluminance() * ISO / K;

    float scale = 0;
    if (apertureovertime > 0)
        scale = q * ISO / (78 * apertureovertime) * pow(2, compensation);
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1)
            setimage("Ci", x, y, photometric(color image("Cs", x, y)) * scale);
}
