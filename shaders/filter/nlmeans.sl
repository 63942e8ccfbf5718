/* SPDX-License-Identifier: Apache-2.0 */

#define WIDEST 64 /* Pixels each way that may be told to be looked at. */

float squared(color c)
{
    return comp(c, 0) * comp(c, 0) + comp(c, 1) * comp(c, 1) + comp(c, 2) * comp(c, 2);
}

/* Squared difference of two colours over its variance, less what noise alone makes of it; the sum
   over channels. */
float dissimilarity(color a, b, va, vb; float per)
{
    color d = a - b;
    color both = va + vb;
    color r = (d * d - both) / (per * both + 1e-12);
    return comp(r, 0) + comp(r, 1) + comp(r, 2);
}

/* Whether a coordinate is one of the picture's. What lies beyond the border differs from
   nothing. */
float inside(float at, size)
{
    return at >= 0 && at < size ? 1 : 0;
}

/* Denoises a picture by non-local means (Buades, Coll and Morel 2005): each pixel becomes the mean
   of those about it whose neighbourhoods look like its own. What is alike the variance tells
   (Rousselle, Knaus and Zwicker 2012), and normals and albedo do.
   docs/filters/nlmeans.md. */
filter nlmeans(
    float search = 7;      /* how far away pixels like one are sought [0 to 64, pixels each way] */
    float patch = 2;       /* how large the neighbourhoods are that are compared [0 to 64, pixels
                              each way] */
    float tolerance = .45; /* of their differences [above 0, standard errors] */
    float bend = .3;       /* of normals: the length of their difference that counts as another
                              [0, they do not count, to 2] */
    float shade = .05;     /* of albedos, likewise [0 to 1] */)
{
    float x, y, i, j, k;
    float reach = min(search, WIDEST), around = min(patch, WIDEST);

    setsize("nlmeans.spread", xsize, ysize);
    setsize("nlmeans.sum", xsize, ysize);
    setsize("nlmeans.weights", xsize, ysize);
    setsize("nlmeans.difference", xsize, ysize);
    setsize("nlmeans.difference_row", xsize, ysize);
    setsize("nlmeans.similar", xsize, ysize);

    /* Variance over three by three pixels; a single one may have more: a path that others
       missed. */
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            color sum = 0;
            for (j = -1; j <= 1; j += 1)
                for (i = -1; i <= 1; i += 1)
                    sum += color image("variance", x + i, y + j);
            setimage("nlmeans.spread", x, y, max(sum / 9, color image("variance", x, y)));
            setimage("nlmeans.sum", x, y, color image("Cs", x, y));
            setimage("nlmeans.weights", x, y, 1);
        }

    float per = tolerance * tolerance;
    float side = 2 * around + 1;
    float scale = 1 / (3 * side * side);
    float bendscale = bend > 0 ? 1 / (bend * bend) : 0;
    float shadescale = shade > 0 ? 1 / (shade * shade) : 0;
    /* Half of the offsets: each stands for its opposite, too. */
    for (j = 0; j <= reach; j += 1)
        for (i = -reach; i <= reach; i += 1)
            if (j > 0 || i > 0) {
                for (y = 0; y < ysize; y += 1)
                    for (x = 0; x < xsize; x += 1)
                        setimage("nlmeans.difference", x, y,
                                 dissimilarity(color image("Cs", x, y),
                                               color image("Cs", x + i, y + j),
                                               color image("nlmeans.spread", x, y),
                                               color image("nlmeans.spread", x + i, y + j), per));
                for (y = 0; y < ysize; y += 1)
                    for (x = 0; x < xsize; x += 1) {
                        float sum = 0;
                        for (k = -around; k <= around; k += 1)
                            if (inside(x + k, xsize) + inside(x + k + i, xsize) == 2)
                                sum += float image("nlmeans.difference", x + k, y);
                        setimage("nlmeans.difference_row", x, y, sum);
                    }
                for (y = 0; y < ysize; y += 1)
                    for (x = 0; x < xsize; x += 1) {
                        float sum = 0;
                        for (k = -around; k <= around; k += 1)
                            if (inside(y + k, ysize) + inside(y + k + j, ysize) == 2)
                                sum += float image("nlmeans.difference_row", x, y + k);
                        float apart = max(0, sum * scale);
                        if (bend > 0)
                            apart += bendscale * squared(color image("N", x, y)
                                                         - color image("N", x + i, y + j));
                        if (shade > 0)
                            apart += shadescale * squared(color image("albedo", x, y)
                                                          - color image("albedo", x + i, y + j));
                        float weight = exp(-apart);
                        /* Nothing is taken from beyond the border. */
                        if (x + i < 0 || x + i >= xsize || y + j >= ysize)
                            weight = 0;
                        setimage("nlmeans.similar", x, y, weight);
                    }
                for (y = 0; y < ysize; y += 1)
                    for (x = 0; x < xsize; x += 1) {
                        float ahead = image("nlmeans.similar", x, y), behind = 0;
                        if (x - i >= 0 && x - i < xsize && y - j >= 0)
                            behind = image("nlmeans.similar", x - i, y - j);
                        setimage("nlmeans.sum", x, y, color image("nlmeans.sum", x, y)
                                 + ahead * color image("Cs", x + i, y + j)
                                 + behind * color image("Cs", x - i, y - j));
                        setimage("nlmeans.weights", x, y,
                                 float image("nlmeans.weights", x, y) + ahead + behind);
                    }
            }
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1)
            setimage("Ci", x, y, color image("nlmeans.sum", x, y)
                                 / float image("nlmeans.weights", x, y));
}
