/* SPDX-License-Identifier: Apache-2.0 */
#include "adaptation.h"

/* Brightness in brils is 10^beta L^alpha, L in lamberts, for a viewer adapted to 10^l lamberts. */
float alphaof(float l) { return .4 * l + 2.92; }
float betaof(float l) { return (-.4 * l - 2.584) * l + 2.0208; }

/* Tone reproduction: shows the scene as bright as its viewer sees it, who adapts to both.
   Gives display values: 1 is L_dmax. J. Tumblin and H. Rushmeier, "Tone reproduction for realistic images",
   IEEE Computer Graphics and Applications 13(6), 1993. */
filter tumblin_rushmeier93(
    float L_dmax = 86;       /* greatest luminance of the display [above 0, cd/m^2] */
    float C_max = 35;        /* greatest contrast of the display [above 1] */
    float displayoffset = 0; /* from the display's middle to what one adapts to; .84 is as much
                                as the scene's, so that its middle is the display's [any,
                                decades] */
    float L_mean = 0;        /* geometric mean of the scene [0, the picture's, or above, cd/m^2] */
    float clip = 1;          /* 0: leaves values below 0 and above 1 [0 or 1] */)
{
    float lambert = PI * 1e-4; /* 1 cd/m^2 */
    float middle = L_mean > 0 ? log(L_mean, 10) : meanlogluminance(1e-4, 0) / log(10);
    float world = middle + log(lambert, 10) + .84;
    float display = log(L_dmax / sqrt(C_max) * lambert, 10) + displayoffset;
    float slope = alphaof(world) / alphaof(display);
    float shift = (betaof(world) - betaof(display)) / alphaof(display);
    float x, y;

    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            color light = photometric(color image("Cs", x, y));
            float luminance = totalluminance(radiometric(light));
            color value = 0;
            if (luminance > 0) {
                float shown = pow(10, slope * log(luminance * lambert, 10) + shift) / lambert;
                value = light * ((shown / L_dmax - 1 / C_max) / luminance);
            }
            if (clip != 0)
                value = clamp(value, color 0, color 1);
            setimage("Ci", x, y, value);
        }
}
