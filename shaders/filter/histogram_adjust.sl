/* SPDX-License-Identifier: Apache-2.0 */

#include "choices.h"

#define BINS 100

/* Luminance that can just be told from L, both cd/m^2 (the paper's table 1, after Ferwerda). */
float justnoticeable(float L)
{
    float l = log(L, 10), d;

    if (l < -3.94)
        d = -2.86;
    else if (l < -1.44)
        d = pow(.405 * l + 1.6, 2.18) - 2.86;
    else if (l < -.0184)
        d = l - .395;
    else if (l < 1.9)
        d = pow(.249 * l + .65, 2.7) - .72;
    else
        d = l - 1.255;
    return pow(10, d);
}

/* The value for a colour that is to be shown with luminance L; 0 is the display's black. */
color displayed(color c; float L, L_dmin, L_dmax)
{
    float luminance = totalluminance(c);
    float value = max((L - L_dmin) / (L_dmax - L_dmin), 0);
    return luminance > 0 ? photometric(c) * (value / luminance) : color 0;
}

/* Tone reproduction: room on the display for the luminances that the picture is rich in.
   Nowhere is there more contrast than a linear scale has (contrast = "linear"), or than a viewer
   would see ("human"). Gives display values. G. Larson, H. Rushmeier, C. Piatko, "A visibility matching tone reproduction operator for high
   dynamic range scenes", IEEE TVCG 3(4), 1997. */
filter histogram_adjust(
    float L_dmax = 100;        /* greatest luminance of the display [above L_dmin, cd/m^2] */
    float L_dmin = 1;          /* least luminance of the display [above 0, cd/m^2] */
    string contrast = "human"; /* what bounds it ["human", "linear" or "none"] */
    float fieldofview = 45;    /* across; the eye adapts to one degree [1 to 170, degrees] */)
{
    float frequency[BINS];
    float share[BINS + 1]; /* of what the eye sees: darker than where a bin begins */
    float x, y, i, j, bin;

    checkchoice("contrast", contrast, "human|linear|none", "linear");

    /* What the eye sees at a glance: means over a degree. */
    float each = max(floor(xsize / max(fieldofview, 1) + .5), 1);
    float across = max(floor(xsize / each), 1), down = max(floor(ysize / each), 1);
    float everywidth = xsize / across, everyheight = ysize / down;
    setsize("histogram_adjust.glances", across, down);
    for (y = 0; y < down; y += 1)
        for (x = 0; x < across; x += 1) {
            float left = floor(x * everywidth + .5), right = floor((x + 1) * everywidth + .5);
            float top = floor(y * everyheight + .5), bottom = floor((y + 1) * everyheight + .5);
            float sum = 0;
            for (j = top; j < bottom; j += 1)
                for (i = left; i < right; i += 1)
                    sum += totalluminance(color image("Cs", i, j, "filter", "nearest"));
            setimage("histogram_adjust.glances", x, y,
                     max(sum / ((right - left) * (bottom - top)), 1e-4));
        }

    float least = 1e30, greatest = 1e-4;
    for (y = 0; y < down; y += 1)
        for (x = 0; x < across; x += 1) {
            least = min(least, float image("histogram_adjust.glances", x, y));
            greatest = max(greatest, float image("histogram_adjust.glances", x, y));
        }
    float darkest = log(least);
    float width = max((log(greatest) - darkest) / BINS, 1e-6);
    for (y = 0; y < down; y += 1)
        for (x = 0; x < across; x += 1) {
            float brightness = log(float image("histogram_adjust.glances", x, y));
            frequency[clamp(floor((brightness - darkest) / width), 0, BINS - 1)] += 1;
        }

    /* Cuts what exceeds the ceiling until there is little to cut. Where nearly all of it does, the
       display has room for the scene as it is. */
    float range = log(L_dmax / L_dmin);
    float tolerance = .025 * across * down;
    float total = across * down, cut = contrast == "none" ? 0 : total;
    while (cut > tolerance && total >= tolerance) {
        float below = 0, kept = 0;
        for (bin = 0; bin < BINS; bin += 1) {
            float ceiling = total * width / range;
            float ahead = below + frequency[bin];
            if (contrast == "human") {
                float scene = exp(darkest + (bin + .5) * width);
                float display = L_dmin * exp(range * (below + ahead) / (2 * total));
                ceiling *= justnoticeable(display) / justnoticeable(scene) * scene / display;
            }
            frequency[bin] = min(frequency[bin], ceiling);
            kept += frequency[bin];
            below = ahead;
        }
        cut = total - kept;
        total = kept;
    }

    if (total < tolerance) {
        float middle = 0;
        for (y = 0; y < down; y += 1)
            for (x = 0; x < across; x += 1)
                middle += log(float image("histogram_adjust.glances", x, y));
        float adaptation = exp(middle / (across * down));
        float factor = pow((1.219 + pow(L_dmax / 2, .4)) / (1.219 + pow(adaptation, .4)), 2.5);
        factor = min(factor, L_dmax / greatest);
        for (y = 0; y < ysize; y += 1)
            for (x = 0; x < xsize; x += 1) {
                color c = image("Cs", x, y);
                setimage("Ci", x, y, displayed(c, factor * totalluminance(c), L_dmin, L_dmax));
            }
    } else {
        for (bin = 0; bin < BINS; bin += 1)
            share[bin + 1] = share[bin] + frequency[bin] / total;
        for (y = 0; y < ysize; y += 1)
            for (x = 0; x < xsize; x += 1) {
                color c = image("Cs", x, y);
                float brightness = log(max(totalluminance(c), 1e-4));
                float at = clamp((brightness - darkest) / width, 0, BINS);
                float whole = min(floor(at), BINS - 1);
                float part = mix(share[whole], share[whole + 1], at - whole);
                setimage("Ci", x, y, displayed(c, L_dmin * exp(range * part), L_dmin, L_dmax));
            }
    }
}
