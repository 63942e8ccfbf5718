/* What runs over whole pictures: filters with sums, maps, neighbours and rows; imagers. */
float weight(color a, b; float sharp) { return exp(-sharp * (a - b) . (a - b)); }
filter smooth(float radius = 2, sharp = 4; string guide = "albedo", mine = "kept"; uniform float grow = 1;)
{
    float x, y, i, j, total = 0, most = 0, w[3] = {1, 2, 1};
    color mean = 0;
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            color sum = 0, c = image("Cs", x, y);
            float all = 0;
            for (j = -radius; j <= radius; j += 1)
                for (i = -radius; i <= radius; i += 1) {
                    float k = weight(color image(guide, x, y), color image(guide, x + i, y + j), sharp);
                    sum += k * image("Cs", x + i, y + j);
                    all += k;
                }
            setimage("Ci", x, y, sum / all);
            setimage(mine, x, y, float image("Z", x, y) + image("N", x, y, "channel", 2));
            mean += c;
            most = max(most, comp(c, 1));
            if (comp(c, 0) > total) total = comp(c, 0);
        }
    for (y = 0; y < ysize; y += 1) {
        float run = 0;
        for (x = 0; x < xsize; x += 1) {
            run = .5 * run + w[mod(x, 3)] * float image(mine, xsize - 1 - x, y, "filter", "triangle", "width", 3);
            setimage(mine, x, y, run);
        }
    }
    setsize("half", ceil(xsize / 2), ceil(ysize / 2));
    for (x = 0; x < xsize / 2; x += 1)
        setimage("half", x, 0, color image("samples", 2 * x, 0, "sample", 1) + color(mean / most));
    if (grow > 1) {
        setsize("Ci", xsize * grow, ysize * grow);
        y = 0;
        while (y < ysize * grow) {
            for (x = 0; x < xsize * grow; x += 1)
                setimage("Ci", x, y, image("half", x / grow, y / grow, "filter", "catmull-rom", "xwidth", 4));
            y += 1;
            if (y > 40) break;
        }
    }
    printf("%f %c %s\n", total, mean, mine);
}
imager framed(color edge = color "hsv" (.1, .5, .5); float wide = .1; string mode = "soft";)
{
    float off = 2 * max(abs(s - .5), abs(t - .5)), k;
    color c = Ci;
    for (k = 0; k < 3; k += 1) setcomp(c, k, pow(comp(c, k), 1 + wide));
    if (mode != "soft" && xcomp(P) > ycomp(P)) c = 1 - c;
    Ci = mix(c + (1 - alpha) * edge, edge, smoothstep(1 - wide, 1, off));
    Oi = 1;
    alpha = max(alpha, step(1 - wide, off));
}
