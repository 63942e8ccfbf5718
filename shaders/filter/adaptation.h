/* SPDX-License-Identifier: Apache-2.0
   What a viewer adapts to: averages of a picture's luminance. Luminance in cd/m^2. */

/* The mean over all pixels. */
float meanluminance()
{
    extern float xsize, ysize;
    float x, y, sum = 0;

    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1)
            sum += totalluminance(color image("Cs", x, y));
    return sum / (xsize * ysize);
}

/* The mean of log(luminance + offset), luminance being at least `least`, over all pixels that show
   something (Oi is not 0); over all where none does. */
float meanlogluminance(float least, offset)
{
    extern float xsize, ysize;
    float x, y, sum = 0, shown = 0, sumshown = 0;

    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            float brightness = log(max(totalluminance(color image("Cs", x, y)), least) + offset);
            sum += brightness;
            if (totalradiance(color image("Oi", x, y)) > 0) {
                shown += 1;
                sumshown += brightness;
            }
        }
    return shown > 0 ? sumshown / shown : sum / (xsize * ysize);
}

/* The greatest luminance of a pixel. */
float greatestluminance()
{
    extern float xsize, ysize;
    float x, y, greatest = 0;

    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1)
            greatest = max(greatest, totalluminance(color image("Cs", x, y)));
    return greatest;
}
