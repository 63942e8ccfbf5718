/* A filter: sums, maps of its own, neighbours, another size. */
filter pixels(float amount = .5, grow = 1; string what = "albedo";)
{
    float x, y, k, brightest = 0, mean = 0, w = xsize, h = ysize;
    float rows[3] = {.25, .5, .25};
    for (y = 0; y < h; y += 1)
        for (x = 0; x < w; x += 1) {
            color c = image("Cs", x, y);
            mean += comp(c, 1) / (w * h);
            if (comp(c, 0) > brightest) brightest = comp(c, 0);
            setimage("mine", x, y, .5 * color image(what, x, y) + float image("variance", x, y));
            setimage("level", x, y, log(1e-6 + max(0, comp(c, 1))));
        }
    for (y = 0; y < h; y += 1) {
        float run = 0;
        for (x = 0; x < w; x += 1) {
            run = mix(run, image("level", x, y), amount);
            setimage("level", x, y, run);
        }
    }
    if (grow != 1)
        setsize("Ci", floor(w * grow), floor(h * grow));
    for (y = 0; y < h * grow; y += 1)
        for (x = 0; x < w * grow; x += 1) {
            color sum = 0;
            for (k = -1; k < 2; k += 1)
                sum += rows[k + 1] * color image("Cs", x / grow + k, y / grow, "filter", "gaussian", "width", 2);
            sum += .01 * color image("samples", x, y, "sample", 1) + image("Z", x, y) * 1e-30;
            setimage("Ci", x, y, sum / max(mean, .1) + .1 * color image("mine", w - 1 - x, y));
        }
    printf("%f %f\n", mean, brightest);
}
