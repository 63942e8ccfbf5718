/* SPDX-License-Identifier: Apache-2.0
   Numbers and units written into pictures: glyphs of 5 x 7 dots, 6 from one to the next. */

#define GLYPHS 20
#define LONGEST 12 /* glyphs of a text */
#define POINT 10
#define LETTER_C 11
#define LETTER_D 12
#define SLASH 13
#define LETTER_M 14
#define SQUARED 15
#define LETTER_L 16
#define LETTER_X 17
#define LETTER_E 18
#define MINUS 19

/* Their rows from the top; 16 is the dot on the left. */
#define GLYPH_ROWS                                                                                 \
    {14, 17, 17, 17, 17, 17, 14, 4, 12, 4, 4, 4, 4, 14, 14, 17, 1, 2, 4, 8, 31,                     \
     14, 17, 1, 6, 1, 17, 14, 2, 6, 10, 18, 31, 2, 2, 31, 16, 30, 1, 1, 17, 14,                     \
     6, 8, 16, 30, 17, 17, 14, 31, 1, 2, 2, 4, 4, 4, 14, 17, 17, 14, 17, 17, 14,                    \
     14, 17, 17, 15, 1, 2, 12, 0, 0, 0, 0, 0, 12, 12, 0, 0, 14, 17, 16, 17, 14,                     \
     1, 1, 15, 17, 17, 17, 15, 1, 1, 2, 4, 8, 16, 16, 0, 0, 26, 21, 21, 21, 21,                     \
     14, 17, 2, 4, 31, 0, 0, 12, 4, 4, 4, 4, 4, 14, 0, 0, 17, 10, 4, 10, 17,                        \
     0, 0, 14, 17, 31, 16, 14, 0, 0, 0, 31, 0, 0, 0}

/* Puts the digits of a whole number that is not negative behind `length` glyphs of a text, with
   `decimals` of them behind a point; gives how long the text is then. */
float appendnumber(output float text[]; float length, number, decimals)
{
    float digits = decimals + 1, at = length, power, i;

    while (digits < 8 && number >= pow(10, digits) - .5)
        digits += 1;
    power = floor(pow(10, digits - 1) + .5);
    for (i = digits; i > 0; i -= 1) {
        if (i == decimals && decimals > 0) {
            text[at] = POINT;
            at += 1;
        }
        text[at] = mod(floor((number + .5) / power), 10);
        at += 1;
        power = floor(power / 10 + .5);
    }
    return at;
}

/* Puts mantissa * 10^exponent there, mantissa whole: in full from .001 to a million, else with its
   exponent behind an e. */
float appendvalue(output float text[]; float length, mantissa, exponent)
{
    float at = length;

    if (mantissa == 0)
        at = appendnumber(text, at, 0, 0);
    else {
        float order = exponent + floor(log(mantissa, 10) + 1e-4);
        if (order >= -4 && order <= 5 && exponent >= 0)
            at = appendnumber(text, at, floor(mantissa * pow(10, exponent) + .5), 0);
        else if (order >= -4 && order <= 5)
            at = appendnumber(text, at, mantissa, -exponent);
        else {
            float decimals = order - exponent, short = mantissa;
            while (decimals > 0 && mod(short, 10) == 0) {
                decimals -= 1;
                short /= 10;
            }
            at = appendnumber(text, at, short, decimals);
            text[at] = LETTER_E;
            at += 1;
            if (order < 0) {
                text[at] = MINUS;
                at += 1;
            }
            at = appendnumber(text, at, abs(order), 0);
        }
    }
    return at;
}
