/* SPDX-License-Identifier: Apache-2.0 */
#include "adaptation.h"
#include "choices.h"
#include "digits.h"

#define TICKS 40 /* at most, of a legend */
#define DECADES 76 /* at most; floats have no more */

/* In cd/m^2 or lx, what a pixel shows. */
float measured(string quantity, map; float x, y)
{
    float value = totalluminance(color image(map, x, y));

    if (quantity == "matteilluminance") {
        float albedo = totalradiance(color image("albedo", x, y));
        value = albedo > 0 ? PI * value / albedo : 0;
    }
    return value;
}

/* The value that this share of the pixels that show something exceeds, to 4 %. */
float exceededby(float part; string quantity, map)
{
    extern float xsize, ysize;
    float low = -6, high = 10, turn, x, y; /* decimal logarithms */

    for (turn = 0; turn < 10; turn += 1) {
        float middle = (low + high) / 2, threshold = pow(10, middle);
        float above = 0, aboveshown = 0, shown = 0;
        for (y = 0; y < ysize; y += 1)
            for (x = 0; x < xsize; x += 1) {
                float opaque = totalradiance(color image("Oi", x, y)) > 0 ? 1 : 0;
                float exceeds = measured(quantity, map, x, y) > threshold ? 1 : 0;
                shown += opaque;
                above += exceeds;
                aboveshown += exceeds * opaque;
            }
        if (shown > 0 ? aboveshown > part * shown : above > part * xsize * ysize)
            low = middle;
        else
            high = middle;
    }
    return pow(10, high);
}

/* The least of 1, 2, 5 times a power of ten that is not below a value. */
float rounded(float value)
{
    float power = pow(10, floor(log(value, 10) + 1e-4));
    float leading = value / power - 1e-3;
    return power * (leading <= 1 ? 1 : leading <= 2 ? 2 : leading <= 5 ? 5 : 10);
}

/* Colours from 0 to 1. */
color shade(string palette; float at)
{
    color c;

    if (palette == "grey")
        c = at;
    else if (palette == "heat")
        c = spline("linear", at, color 0, color 0, color(.02, 0, .12), color(.2, 0, .25),
                   color(.6, .02, .12), color(.95, .15, .01), color(1, .45, .02),
                   color(1, 1, .6), color 1);
    else
        c = spline("linear", at, color 0, color(.01, 0, .06), color(.03, .01, .5), color(0, .15, .9),
                   color(0, .5, .5), color(.03, .5, .05), color(.7, .75, 0), color(1, .3, 0),
                   color(.9, .02, 0), color(1, .5, .6), color 1);
    return c;
}

/* Where a value lies on the scale: 0 at its bottom, 1 at its top. */
float placeof(float value, top, decades)
{
    float at = value / top;

    if (decades > 0)
        at = at > 0 ? 1 + log(at, 10) / decades : 0;
    return clamp(at, 0, 1);
}

/* Which of the legend's steps a value lies in. */
float stepof(float value, top, decades, dense)
{
    float found;

    if (decades == 0)
        found = floor(value * 10 / top);
    else {
        float l = log(max(value, 1e-30), 10) + 1e-5;
        float leading = l - floor(l); /* log10 of 1, 2 and 5 are 0, .30103 and .69897 */
        found = floor(l);
        if (dense != 0)
            found = 3 * found + (leading >= .69897 ? 2 : leading >= .30103 ? 1 : 0);
    }
    return found;
}

/* The legend's values, as whole mantissas and decimal exponents; gives how many there are. */
float maketicks(output float mantissas[], exponents[]; float top, decades, dense)
{
    float count = 0, n;

    if (decades == 0) {
        float exponent = floor(log(top / 10, 10) + 1e-4) - 2;
        float mantissa = floor(top / 10 / pow(10, exponent) + .5);
        while (mod(mantissa, 10) == 0) {
            mantissa /= 10;
            exponent += 1;
        }
        for (n = 0; n <= 10; n += dense != 0 ? 1 : 5) {
            mantissas[count] = n * mantissa;
            exponents[count] = exponent;
            count += 1;
        }
    } else {
        float highest = log(top, 10) + 1e-4, lowest = highest - decades - 2e-4;
        float exponent;
        for (exponent = floor(lowest); exponent <= highest; exponent += 1)
            for (n = 0; n < (dense != 0 ? 3 : 1); n += 1) {
                float leading = n == 0 ? 1 : n == 1 ? 2 : 5;
                float l = exponent + log(leading, 10);
                if (l >= lowest && l <= highest && count < TICKS) {
                    mantissas[count] = leading;
                    exponents[count] = exponent;
                    count += 1;
                }
            }
    }
    return count;
}

/* Shows luminance or illuminance as colours, with a legend in cd/m^2 or lx, or as contour lines. */
filter falsecolor(
    string quantity = "luminance"; /* "luminance", of a radiance, cd/m^2; "illuminance", of an
                                      irradiance, W/m^2, in lx; "matteilluminance", of a radiance
                                      of matte surfaces and their albedo, lx [one of these] */
    string map = "Cs";             /* the picture of that radiance or irradiance [a map's name] */
    float scale = 0;               /* the value at the top [0, what .5 % of the pixels exceed, or
                                      above, cd/m^2 or lx] */
    float log = 0;                 /* whether the scale is logarithmic [0 or 1] */
    float decades = 0;             /* how many it has [0, down to what 98 % exceed, or above,
                                      decades] */
    string palette = "spectrum";   /* its colours ["spectrum", "heat" or "grey"] */
    float contours = 0;            /* 1: lines at the legend's values; 2: on the picture itself
                                      [0, 1 or 2] */
    float legend = 1;              /* 0: none; 1: on the picture's right; 2: beside it [0, 1 or
                                      2] */)
{
    checkchoice("quantity", quantity, "luminance|illuminance|matteilluminance", "illuminance");
    checkchoice("palette", palette, "spectrum|heat|grey", "spectrum");
    float x, y, i, j, n;
    float dots = max(floor(min(xsize / 320, ysize / 240)), 1); /* pixels of a glyph's dot */
    float panel = 56 * dots;
    float drawn = legend != 0 && xsize >= 100 && ysize >= 90 ? 1 : 0;
    float top = scale > 0 ? scale : rounded(exceededby(.005, quantity, map));
    float span = 0; /* decades; 0: linear */

    if (log != 0)
        span = decades > 0 ? min(decades, DECADES)
                           : clamp(ceil(log(top / exceededby(.98, quantity, map), 10)), 1, 8);

    float barbottom = ysize - 8 * dots, bartop = 18 * dots;
    float steps = span > 0 ? 3 * span : 10;
    float dense = span <= 5 && (barbottom - bartop) / steps >= 9 * dots ? 1 : 0;
    float lineswidth = max(dots / 2, 1);
    float exposure = contours == 2 ? .18 / exp(meanlogluminance(0, 1e-4)) : 0;

    if (drawn != 0 && legend == 2)
        setsize("Ci", xsize + panel, ysize);
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            float value = measured(quantity, map, x, y);
            color shown = shade(palette, placeof(value, top, span));
            if (contours != 0) {
                float here = stepof(value, top, span, dense);
                float right = measured(quantity, map, x + lineswidth, y);
                float below = measured(quantity, map, x, y + lineswidth);
                float line = stepof(right, top, span, dense) != here ||
                             stepof(below, top, span, dense) != here;
                if (contours == 2)
                    shown = line != 0 ? shade(palette, placeof(max(value, max(right, below)),
                                                               top, span))
                                      : min(photometric(color image("Cs", x, y)) * exposure,
                                            color 1);
                else if (line != 0)
                    shown = 0;
            }
            setimage("Ci", x, y, shown);
        }

    if (drawn != 0) {
        float rows[GLYPHS * 7] = GLYPH_ROWS;
        float mantissas[TICKS], exponents[TICKS], text[LONGEST];
        float left = legend == 2 ? xsize : xsize - panel;
        float barleft = left + 4 * dots, barright = barleft + 10 * dots;
        float count = maketicks(mantissas, exponents, top, span, dense);

        for (y = 0; y < ysize; y += 1)
            for (x = left; x < left + panel; x += 1) {
                color c = .01;
                if (x >= barleft && x < barright && y >= bartop && y < barbottom)
                    c = shade(palette, (barbottom - .5 - y) / (barbottom - bartop));
                setimage("Ci", x, y, c);
            }

        for (n = -1; n < count; n += 1) { /* -1: the unit */
            float length, textleft = barleft, texttop = 5 * dots;
            if (n < 0 && quantity == "luminance") {
                text[0] = LETTER_C;
                text[1] = LETTER_D;
                text[2] = SLASH;
                text[3] = LETTER_M;
                text[4] = SQUARED;
                length = 5;
            } else if (n < 0) {
                text[0] = LETTER_L;
                text[1] = LETTER_X;
                length = 2;
            } else {
                float value = mantissas[n] * pow(10, exponents[n]);
                float at = barbottom - placeof(value, top, span) * (barbottom - bartop);
                float line = floor(at - dots / 2);
                length = appendvalue(text, 0, mantissas[n], exponents[n]);
                textleft = barright + 4 * dots;
                texttop = line - 3 * dots;
                for (y = line; y < line + dots; y += 1)
                    for (x = barright; x < barright + 3 * dots; x += 1)
                        setimage("Ci", x, y, .9);
            }
            for (i = 0; i < length; i += 1)
                for (j = 0; j < 7; j += 1) {
                    float bits = rows[text[i] * 7 + j], dot;
                    for (dot = 0; dot < 5; dot += 1) {
                        if (bits >= 16)
                            for (y = 0; y < dots; y += 1)
                                for (x = 0; x < dots; x += 1)
                                    setimage("Ci", textleft + (6 * i + dot) * dots + x,
                                             texttop + j * dots + y, .9);
                        bits = mod(bits, 16) * 2;
                    }
                }
        }
    }
}
