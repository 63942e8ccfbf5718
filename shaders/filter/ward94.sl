/* SPDX-License-Identifier: Apache-2.0 */
#include "adaptation.h"

/* Tone reproduction: one factor, by which what can just be told apart stays so on the display.
   Gives display values: 1 is L_dmax. G. Ward, "A contrast-based scalefactor for luminance display",
   Graphics Gems IV, 1994. */
filter ward94(
    float L_dmax = 100;   /* greatest luminance of the display [above 0, cd/m^2] */
    float logaverage = 0; /* 0: adapted to the mean; 1: to the mean of logarithms [0 or 1] */
    float L_wa = 0;       /* adapted to this luminance [0, the picture's, or above, cd/m^2] */)
{
    float x, y;

    float adaptation = L_wa;
    if (adaptation <= 0)
        adaptation = logaverage != 0 ? exp(meanlogluminance(0, 1e-4)) : meanluminance();

    float scale = pow((1.219 + pow(L_dmax / 2, .4)) / (1.219 + pow(adaptation, .4)), 2.5) / L_dmax;
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1)
            setimage("Ci", x, y, photometric(color image("Cs", x, y)) * scale);
}
