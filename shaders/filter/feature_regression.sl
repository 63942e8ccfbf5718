/* SPDX-License-Identifier: Apache-2.0 */

#define WIDEST 64          /* Pixels each way that may be told to be looked at. */
#define ALBEDO_FLOOR .0002 /* What has no albedo is seen by this much. */
#define PLAIN_SPREAD .3   /* Of outlines: squared difference over the sum of variances. */

/* Squared difference of two colours over its variance, less what noise alone makes of it; the sum
   over channels. */
float dissimilarity(color a, b, va, vb; float per)
{
    color d = a - b;
    color both = va + vb;
    color r = (d * d - both) / (per * both + 1e-12);
    return comp(r, 0) + comp(r, 1) + comp(r, 2);
}

float squared(color c)
{
    return comp(c, 0) * comp(c, 0) + comp(c, 1) * comp(c, 1) + comp(c, 2) * comp(c, 2);
}

/* Whether a coordinate is one of the picture's. What lies beyond the border differs from
   nothing. */
float inside(float at, size)
{
    return at >= 0 && at < size ? 1 : 0;
}

/* Denoises a picture by first-order regression on features (after Moon et al. 2014 and Bitterli et
   al. 2016): about each pixel the colour is taken to be the albedo times a linear function of the
   place. Who takes part in the fit, and by how much, is what non-local means makes of the light
   alone, the colour over the albedo, whose noise the variance tells, and of the normals.
   Where colour falls as albedo rises (the outline of a lamp), albedo explains nothing: there the
   colour itself is a linear function of the place.
   docs/filters/feature_regression.md. */
filter feature_regression(
    float search = 5;        /* how far away light like a pixel's own is sought [0 to 64, pixels
                                each way] */
    float patch = 2;         /* how large the patches are that are compared [0 to 64, pixels each
                                way] */
    float tolerance = .35;   /* of patches [above 0, standard errors] */
    float radius = 7;        /* how far a fit reaches [0 to 64, pixels each way] */
    float fittolerance = .3; /* of the light that a fit takes in [above 0, standard errors] */
    float contrast = .12;    /* and besides, as a share of the light [0 to 1] */
    float bend = .3;         /* of normals: the length of their difference that counts as
                                another [0 to 2] */)
{
    float x, y, i, j, k;
    float reach = min(search, WIDEST), around = min(patch, WIDEST), fit = min(radius, WIDEST);

    setsize("regression.light", xsize, ysize);
    setsize("regression.light_error", xsize, ysize);
    setsize("regression.light_variance", xsize, ysize);
    setsize("regression.similar_sum", xsize, ysize);
    setsize("regression.similar_weights", xsize, ysize);
    setsize("regression.similar_variance", xsize, ysize);
    setsize("regression.difference", xsize, ysize);
    setsize("regression.difference_row", xsize, ysize);
    setsize("regression.similar", xsize, ysize);
    setsize("regression.pilot", xsize, ysize);
    setsize("regression.pilot_variance", xsize, ysize);
    setsize("regression.outline", xsize, ysize);

    /* The light: what a white surface would show. Its variance, over three by three pixels. */
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            color seen = color image("albedo", x, y) + ALBEDO_FLOOR;
            setimage("regression.light", x, y, color image("Cs", x, y) / seen);
            setimage("regression.light_error", x, y, color image("variance", x, y) / (seen * seen));
        }
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            color sum = 0;
            for (j = -1; j <= 1; j += 1)
                for (i = -1; i <= 1; i += 1)
                    sum += color image("regression.light_error", x + i, y + j);
            /* A single pixel may have a variance of its own: one path that others missed. */
            setimage("regression.light_variance", x, y,
                     max(sum / 9, color image("regression.light_error", x, y)));
        }

    /* Non-local means of the light. Each offset stands for its opposite, too. The pixel itself is
       the first to take part. */
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            setimage("regression.similar_sum", x, y, color image("regression.light", x, y));
            setimage("regression.similar_weights", x, y, 1);
            setimage("regression.similar_variance", x, y,
                     color image("regression.light_variance", x, y));
        }
    float per = tolerance * tolerance;
    float side = 2 * around + 1;
    float scale = 1 / (3 * side * side);
    for (j = 0; j <= reach; j += 1)
        for (i = -reach; i <= reach; i += 1)
            if (j > 0 || i > 0) {
                for (y = 0; y < ysize; y += 1)
                    for (x = 0; x < xsize; x += 1)
                        setimage("regression.difference", x, y,
                                 dissimilarity(color image("regression.light", x, y),
                                               color image("regression.light", x + i, y + j),
                                               color image("regression.light_variance", x, y),
                                               color image("regression.light_variance", x + i,
                                                           y + j), per));
                for (y = 0; y < ysize; y += 1)
                    for (x = 0; x < xsize; x += 1) {
                        float sum = 0;
                        for (k = -around; k <= around; k += 1)
                            if (inside(x + k, xsize) + inside(x + k + i, xsize) == 2)
                                sum += float image("regression.difference", x + k, y);
                        setimage("regression.difference_row", x, y, sum);
                    }
                for (y = 0; y < ysize; y += 1)
                    for (x = 0; x < xsize; x += 1) {
                        float sum = 0;
                        for (k = -around; k <= around; k += 1)
                            if (inside(y + k, ysize) + inside(y + k + j, ysize) == 2)
                                sum += float image("regression.difference_row", x, y + k);
                        color turn = color image("N", x, y) - color image("N", x + i, y + j);
                        float weight = exp(-max(0, sum * scale) - squared(turn) / (bend * bend));
                        /* Nothing is taken from beyond the border. */
                        if (x + i < 0 || x + i >= xsize || y + j >= ysize)
                            weight = 0;
                        setimage("regression.similar", x, y, weight);
                    }
                for (y = 0; y < ysize; y += 1)
                    for (x = 0; x < xsize; x += 1) {
                        float ahead = float image("regression.similar", x, y);
                        float behind = 0;
                        if (x - i >= 0 && x - i < xsize && y - j >= 0)
                            behind = float image("regression.similar", x - i, y - j);
                        setimage("regression.similar_sum", x, y,
                                 color image("regression.similar_sum", x, y)
                                     + ahead * color image("regression.light", x + i, y + j)
                                     + behind * color image("regression.light", x - i, y - j));
                        setimage("regression.similar_weights", x, y,
                                 float image("regression.similar_weights", x, y) + ahead + behind);
                        color other = image("regression.light_variance", x + i, y + j);
                        color opposite = image("regression.light_variance", x - i, y - j);
                        setimage("regression.similar_variance", x, y,
                                 color image("regression.similar_variance", x, y)
                                     + ahead * ahead * other + behind * behind * opposite);
                    }
            }
    /* The pilot, and what is left of its variance. */
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            float weights = image("regression.similar_weights", x, y);
            setimage("regression.pilot", x, y,
                     color image("regression.similar_sum", x, y) / weights);
            setimage("regression.pilot_variance", x, y,
                     color image("regression.similar_variance", x, y) / (weights * weights));
        }

    /* Where colour falls as albedo rises, clearly and by much. */
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            color sum_c = 0, sum_a = 0, sum_cc = 0, sum_ca = 0, sum_aa = 0;
            for (j = -1; j <= 1; j += 1)
                for (i = -1; i <= 1; i += 1) {
                    color c = image("Cs", x + i, y + j);
                    color a = image("albedo", x + i, y + j);
                    sum_c += c;
                    sum_a += a;
                    sum_cc += c * c;
                    sum_ca += c * a;
                    sum_aa += a * a;
                }
            color together = 9 * sum_ca - sum_c * sum_a;
            color means = sum_c * sum_c;
            color spread_c = 9 * sum_cc - means;
            color means_a = sum_a * sum_a;
            color spread_a = 9 * sum_aa - means_a;
            float covariance = comp(together, 0) + comp(together, 1) + comp(together, 2);
            float variance_c = comp(spread_c, 0) + comp(spread_c, 1) + comp(spread_c, 2);
            float variance_a = comp(spread_a, 0) + comp(spread_a, 1) + comp(spread_a, 2);
            float level = comp(means, 0) + comp(means, 1) + comp(means, 2);
            float level_a = comp(means_a, 0) + comp(means_a, 1) + comp(means_a, 2);
            float plain = 0;
            if (covariance < 0 && covariance * covariance > .5 * variance_c * variance_a
                && variance_c > .1 * level && variance_a > .01 * level_a)
                plain = 1;
            setimage("regression.outline", x, y, plain);
        }

    /* The fit: about (x, y), colour = basis * (b0 + b1 i + b2 j); what is wanted is b0. */
    float fitper = fittolerance * fittolerance;
    float turnscale = 1 / (bend * bend);
    float nearness = 1 / (fit * fit);
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            float plain = float image("regression.outline", x, y);
            color own = image("regression.pilot", x, y);
            color own_c = image("Cs", x, y);
            color own_a = color image("albedo", x, y) + ALBEDO_FLOOR;
            color own_n = image("N", x, y);
            color own_v = image("regression.pilot_variance", x, y);
            color own_cv = image("variance", x, y);
            color slack = contrast * contrast * own * own + 1e-12;
            color s00 = 0, s10 = 0, s11 = 0, s20 = 0, s21 = 0, s22 = 0, t0 = 0, t1 = 0, t2 = 0;
            for (j = -fit; j <= fit; j += 1)
                for (i = -fit; i <= fit; i += 1) {
                    color c = image("Cs", x + i, y + j);
                    color basis = (color image("albedo", x + i, y + j) + ALBEDO_FLOOR) / own_a;
                    color d = color image("regression.pilot", x + i, y + j) - own;
                    color v = own_v + color image("regression.pilot_variance", x + i, y + j);
                    color r = d * d / (fitper * v + slack);
                    float far = (i * i + j * j) * nearness;
                    if (plain > 0) {
                        d = c - own_c;
                        r = d * d / (PLAIN_SPREAD * (own_cv + color image("variance", x + i, y + j))
                                     + 1e-12);
                        basis = 1;
                        far = 0;
                    }
                    color turn = color image("N", x + i, y + j) - own_n;
                    float weight = exp(-(comp(r, 0) + comp(r, 1) + comp(r, 2)) / 3
                                       - squared(turn) * turnscale - far);
                    color w = weight * basis * basis;
                    color wt = weight * basis * c;
                    s00 += w;
                    s10 += w * i;
                    s11 += w * (i * i);
                    s20 += w * j;
                    s21 += w * (i * j);
                    s22 += w * (j * j);
                    t0 += wt;
                    t1 += wt * i;
                    t2 += wt * j;
                }
            /* A little ridge: slopes that nothing decides are none. */
            color ridge = (plain > 0 ? .02 * 9 : .001 * fit * fit) * s00;
            s11 += ridge;
            s22 += ridge;
            /* b1 and b2 out of the first equation. */
            color det = s11 * s22 - s21 * s21;
            color u1 = (s10 * s22 - s20 * s21) / det;
            color u2 = (s20 * s11 - s10 * s21) / det;
            color b0 = (t0 - u1 * t1 - u2 * t2) / (s00 - u1 * s10 - u2 * s20);
            /* Slopes that noise has made do not lead far from the mean. */
            color mean = t0 / s00;
            setimage("Ci", x, y, clamp(b0, .5 * mean, 2 * mean));
        }
}
