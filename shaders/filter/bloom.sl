/* SPDX-License-Identifier: Apache-2.0 */

/* The function, in 1/sr at an angle of t degrees, is a sum of terms a / (1 + (t/b)^2)^m, each of
   which is a sum of Gaussians: a / Gamma(m) times the integral of u^m e^-u e^(-u t^2/b^2) over
   log(u). Level k of a pyramid is blurred by a Gaussian twice as wide as the level before; its
   weight is that integral's share about u = b^2 / (2 s^2), s being its deviation. */
float termweight(float a, b, m, gammam, deviation)
{
    float u = b * b / (2 * deviation * deviation);
    float radians2 = 2 * PI * deviation * deviation * (PI / 180) * (PI / 180);
    return a / gammam * pow(u, m) * exp(-u) * radians2;
}

float glareweight(float deviation, age, pigment)
{
    float old = pow(age / 70, 4);
    float core = termweight(9.2e6, .0046, 1.5, .886227, deviation) +
                 termweight(1.5e5, .045, 1.5, .886227, deviation);
    float wide = termweight(400, .1, 1, 1, deviation);
    float coloured = termweight(1300, .1, 1.5, .886227, deviation) +
                     termweight(.8, .1, .5, 1.772454, deviation);
    return (1 - .08 * old) * core + (1 + 1.6 * old) * (wide + pigment * coloured);
}

/* Blurs by a deviation of one pixel, with the weights 1 4 6 4 1 across and then down. */
void blur(string from, to; float width, height)
{
    float x, y;

    setsize("bloom.across", width, height);
    for (y = 0; y < height; y += 1)
        for (x = 0; x < width; x += 1) {
            color near = color image(from, x - 1, y) + color image(from, x + 1, y);
            color far = color image(from, x - 2, y) + color image(from, x + 2, y);
            setimage("bloom.across", x, y,
                     (6 * color image(from, x, y) + 4 * near + far) / 16);
        }
    for (y = 0; y < height; y += 1)
        for (x = 0; x < width; x += 1) {
            color near = color image("bloom.across", x, y - 1) +
                         color image("bloom.across", x, y + 1);
            color far = color image("bloom.across", x, y - 2) +
                        color image("bloom.across", x, y + 2);
            setimage(to, x, y, (6 * color image("bloom.across", x, y) + 4 * near + far) / 16);
        }
}

/* A level of half the size, blurred. Halfway between four pixels is their mean. */
void makelevel(string finer, level; float width, height)
{
    float x, y;

    for (y = 0; y < height; y += 1)
        for (x = 0; x < width; x += 1)
            setimage(level, x, y, color image(finer, 2 * x + .5, 2 * y + .5));
    blur(level, level, width, height);
}

/* What the coarser levels have summed, and this one by its weight. */
void addlevel(string level, coarser; float width, height, weight)
{
    float x, y;

    for (y = 0; y < height; y += 1)
        for (x = 0; x < width; x += 1)
            setimage(level, x, y, weight * color image(level, x, y) +
                                  color image(coarser, x / 2 - .25, y / 2 - .25));
}

#define LEVELS 10
#define SIZE(k) ceil(xsize / pow(2, k)), ceil(ysize / pow(2, k))

/* Veiling glare: what a viewer's eye scatters about bright places, by the CIE's glare function.
   Light goes elsewhere, none is lost or made. Same units as before.
   J. Vos, T. van den Berg, "Report on disability glare", CIE 135/1, 1999. */
filter bloom(
    float fieldofview = 45; /* how wide the picture is to its viewer's eye [1 to 170, degrees] */
    float age = 25;         /* of the viewer [0 to 120, years] */
    float pigment = .5;     /* of the eye [0, black, .5, brown, to 1.2, very light blue] */
    float strength = 1;     /* times as much light is scattered [0 up] */)
{
    float weights[LEVELS];
    float pixel = fieldofview / xsize; /* degrees */
    float levels = min(max(floor(log(min(xsize, ysize), 2) + 1e-3), 1), LEVELS);
    float x, y, k, spread = 0;
    color before = 0, after = 0;

    /* What is narrower than level 0 stays in its pixel, and so does what is wider than the
       picture. Level k deviates by sqrt((5 4^k - 2) / 3) pixels: its own blur, those before,
       the means of four and the interpolation. */
    for (k = 0; k < levels; k += 1) {
        float steep = 5 * pow(4, k);
        float deviation = sqrt((steep - 2) / 3) * pixel;
        float step = log(4) * steep / (steep - 2);
        weights[k] = strength * step * glareweight(deviation, age, pigment);
        spread += weights[k];
    }
    float evenly = strength * 2.5e-3 * pigment * xsize * ysize * pow(radians(pixel), 2);
    if (spread + evenly > 1) {
        for (k = 0; k < levels; k += 1)
            weights[k] /= spread + evenly;
        evenly /= spread + evenly;
        spread = 1 - evenly;
    }

    setsize("bloom.0", SIZE(0));
    setsize("bloom.1", SIZE(1));
    setsize("bloom.2", SIZE(2));
    setsize("bloom.3", SIZE(3));
    setsize("bloom.4", SIZE(4));
    setsize("bloom.5", SIZE(5));
    setsize("bloom.6", SIZE(6));
    setsize("bloom.7", SIZE(7));
    setsize("bloom.8", SIZE(8));
    setsize("bloom.9", SIZE(9));
    blur("Cs", "bloom.0", SIZE(0));
    if (levels > 1)
        makelevel("bloom.0", "bloom.1", SIZE(1));
    if (levels > 2)
        makelevel("bloom.1", "bloom.2", SIZE(2));
    if (levels > 3)
        makelevel("bloom.2", "bloom.3", SIZE(3));
    if (levels > 4)
        makelevel("bloom.3", "bloom.4", SIZE(4));
    if (levels > 5)
        makelevel("bloom.4", "bloom.5", SIZE(5));
    if (levels > 6)
        makelevel("bloom.5", "bloom.6", SIZE(6));
    if (levels > 7)
        makelevel("bloom.6", "bloom.7", SIZE(7));
    if (levels > 8)
        makelevel("bloom.7", "bloom.8", SIZE(8));
    if (levels > 9)
        makelevel("bloom.8", "bloom.9", SIZE(9));
    for (y = 0; y < ceil(ysize / pow(2, 9)); y += 1)
        for (x = 0; x < ceil(xsize / pow(2, 9)); x += 1)
            setimage("bloom.9", x, y, weights[9] * color image("bloom.9", x, y));
    addlevel("bloom.8", "bloom.9", SIZE(8), weights[8]);
    addlevel("bloom.7", "bloom.8", SIZE(7), weights[7]);
    addlevel("bloom.6", "bloom.7", SIZE(6), weights[6]);
    addlevel("bloom.5", "bloom.6", SIZE(5), weights[5]);
    addlevel("bloom.4", "bloom.5", SIZE(4), weights[4]);
    addlevel("bloom.3", "bloom.4", SIZE(3), weights[3]);
    addlevel("bloom.2", "bloom.3", SIZE(2), weights[2]);
    addlevel("bloom.1", "bloom.2", SIZE(1), weights[1]);
    addlevel("bloom.0", "bloom.1", SIZE(0), weights[0]);

    /* Levels of an odd size count their last pixels twice: what is scattered is brought to what it
       has to be in all. */
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            before += color image("Cs", x, y);
            after += color image("bloom.0", x, y);
        }
    color balance = 0;
    for (k = 0; k < 3; k += 1)
        if (comp(after, k) != 0)
            setcomp(balance, k, spread * comp(before, k) / comp(after, k));
    color everywhere = before * (evenly / (xsize * ysize));
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1)
            setimage("Ci", x, y, (1 - spread - evenly) * color image("Cs", x, y) +
                                 balance * color image("bloom.0", x, y) + everywhere);
}
