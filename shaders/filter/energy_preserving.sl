/* SPDX-License-Identifier: Apache-2.0 */

#include "choices.h"

#define ALBEDO_FLOOR .0002
#define REACH 32      /* Pixels that a disc goes out, at most. */
#define PLACES 3400   /* More than there are within REACH. */
#define FEWEST 3      /* Converged neighbours that are enough. */
#define TURN .3       /* The length of normals' difference that is another side. */
#define NARROWEST .3  /* Standard deviation of a Gaussian that stays in its pixel, in pixels. */

color rooted(color c)
{
    return color (sqrt(comp(c, 0)), sqrt(comp(c, 1)), sqrt(comp(c, 2)));
}

/* True where light may go to and come from: in the picture, on the same object and as it faces. */
float receives(float x, y, object; color facing)
{
    if (x < 0 || x >= xsize || y < 0 || y >= ysize)
        return 0;
    color turn = color image("preserving.facing", x, y) - facing;
    color square = turn * turn;
    return float image("preserving.object", x, y) == object
           && comp(square, 0) + comp(square, 1) + comp(square, 2) < TURN * TURN ? 1 : 0;
}

/* Spreads what single samples have brought to a few pixels over as many that nobody sees it:
   H. Rushmeier and G. Ward, "Energy preserving non-linear filters", SIGGRAPH 94. The picture's sum
   stays. For radiance: it comes before tone mapping.
   By variance: a pixel whose 95 % interval is wide becomes the mean of its converged neighbours;
   the difference goes to the pixels about it, each getting less than the eye sees. By fraction,
   where no variance is known: a pixel that stands out is a Gaussian so wide that it adds no more
   than a fraction to any pixel.
   docs/filters/energy_preserving.md. */
filter energy_preserving(
    string by = "variance";  /* how outliers are found ["variance" or "fraction"] */
    float steps = 8;         /* by variance: converged is what is known to so many grey steps
                                [above 0] */
    float levels = 128;      /* grey steps from black to the average [1 up] */
    float average = 0;       /* luminance [0, the picture's but for lamps, or above, cd/m^2] */
    float fraction = .01;    /* by fraction: of its neighbourhood that a pixel may add to others
                                [0 to 1] */
    float radius = 8;        /* by fraction: how far a Gaussian goes out at most [0 to 32,
                                pixels] */
    float textured = 1;      /* 1: what the albedo explains is no noise; 0: as the paper has it
                                [0 or 1] */
    float withinobjects = 1; /* whether nothing goes across outlines and edges of objects [0 or
                                1] */)
{
    float x, y, i, j, k;

    checkchoice("by", by, "variance|fraction", "fraction");
    setsize("preserving.seen", xsize, ysize);
    setsize("preserving.object", xsize, ysize);
    setsize("preserving.facing", xsize, ysize);
    setsize("preserving.noisy", xsize, ysize);
    setsize("preserving.goes", xsize, ysize);
    setsize("preserving.extent", xsize, ysize);
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            color seen = 1;
            if (textured != 0)
                seen = color image("albedo", x, y) + ALBEDO_FLOOR;
            setimage("preserving.seen", x, y, seen);
        }

    /* The average of the picture, then of what is no more than four times as bright: no lamps. */
    float within = average;
    if (average <= 0) {
        float sum = 0, part = 0, count = 0;
        for (y = 0; y < ysize; y += 1)
            for (x = 0; x < xsize; x += 1)
                sum += totalluminance(color image("Cs", x, y));
        float bound = 4 * sum / (xsize * ysize);
        for (y = 0; y < ysize; y += 1)
            for (x = 0; x < xsize; x += 1) {
                float own = totalluminance(color image("Cs", x, y));
                if (own <= bound) {
                    part += own;
                    count += 1;
                }
            }
        within = part / max(count, 1);
    }
    float visible = within / levels;

    /* Outlines are mixtures of objects: objects of their own, which is to say none (-1). */
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            float object = image("id", x, y);
            if (withinobjects == 0)
                object = 0;
            float own = object;
            for (j = -1; j <= 1; j += 1)
                for (i = -1; i <= 1; i += 1)
                    if (withinobjects != 0 && float image("id", x + i, y + j) != own)
                        object = -1;
            setimage("preserving.object", x, y, object);
            color facing = 0;
            if (withinobjects != 0)
                facing = image("N", x, y);
            setimage("preserving.facing", x, y, facing);
            float noisy = 1;
            if (by == "variance"
                && 1.96 * totalluminance(rooted(color image("variance", x, y))) < steps * visible)
                noisy = 0;
            setimage("preserving.noisy", x, y, noisy);
        }

    /* What goes out from each pixel, and over how many places or how far. */
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            float object = image("preserving.object", x, y);
            float noisy = image("preserving.noisy", x, y);
            color facing = image("preserving.facing", x, y);
            color own = image("Cs", x, y);
            color seen = image("preserving.seen", x, y);
            color goes = 0;
            float extent = 0;
            if (object >= 0 && noisy > 0 && by == "variance") {
                /* Neighbours that have converged; if there are not even three, all within two
                   pixels, by how well they are known beside this one: outliers count little. */
                float own_deviation = totalluminance(rooted(color image("variance", x, y)) / seen);
                float own_square = own_deviation * own_deviation;
                color near = 0, all = 0;
                float near_count = 0, all_count = 0;
                for (j = -2; j <= 2; j += 1)
                    for (i = -2; i <= 2; i += 1)
                        if ((i != 0 || j != 0) && receives(x + i, y + j, object, facing) != 0) {
                            color light = color image("Cs", x + i, y + j)
                                        / color image("preserving.seen", x + i, y + j);
                            float deviation = totalluminance(
                                rooted(color image("variance", x + i, y + j))
                                / color image("preserving.seen", x + i, y + j));
                            float known = 1 / (deviation * deviation + own_square
                                               + visible * visible);
                            all += known * light;
                            all_count += known;
                            if (float image("preserving.noisy", x + i, y + j) == 0
                                && max(abs(i), abs(j)) < 2) {
                                near += light;
                                near_count += 1;
                            }
                        }
                if (near_count < FEWEST) {
                    near = all;
                    near_count = all_count;
                }
                if (near_count > 0 && visible > 0) {
                    goes = own - near / near_count * seen;
                    extent = max(1, ceil(abs(totalluminance(goes)) / visible));
                }
            }
            if (object >= 0 && by != "variance") {
                /* The ring about it, by a Gaussian of one pixel. */
                color ring = 0;
                float weights = 0;
                for (j = -2; j <= 2; j += 1)
                    for (i = -2; i <= 2; i += 1)
                        if ((i != 0 || j != 0) && receives(x + i, y + j, object, facing) != 0) {
                            float weight = exp(-(i * i + j * j) / 2);
                            ring += weight * color image("Cs", x + i, y + j)
                                  / color image("preserving.seen", x + i, y + j);
                            weights += weight;
                        }
                float about = totalluminance(ring);
                if (about > 0) {
                    /* How much wider than its pixel: widen^2 >= |q - 1| / fraction + q. */
                    float q = weights * totalluminance(own / seen) / about;
                    float widen = sqrt(q + abs(q - 1) / fraction);
                    goes = own - ring / weights * seen;
                    extent = clamp(NARROWEST * widen, NARROWEST, radius / 3);
                }
            }
            setimage("preserving.goes", x, y, goes);
            setimage("preserving.extent", x, y, extent);
        }

    /* Places about a pixel, the nearest first and each with its opposite. */
    float placex[PLACES], placey[PLACES];
    float places = 0, square = 0;
    for (square = 0; square <= REACH * REACH; square += 1)
        for (j = 0; j * j <= square; j += 1) {
            i = floor(sqrt(square - j * j) + .5);
            if (i * i + j * j == square) {
                placex[places] = i;
                placey[places] = j;
                places += 1;
                if (square > 0) {
                    placex[places] = -i;
                    placey[places] = -j;
                    places += 1;
                }
                if (i != 0 && j != 0) {
                    placex[places] = -i;
                    placey[places] = j;
                    placex[places + 1] = i;
                    placey[places + 1] = -j;
                    places += 2;
                }
            }
        }

    /* Each spreads what it gives: the shares are as much as they sum to, borders or not. */
    for (y = 0; y < ysize; y += 1)
        for (x = 0; x < xsize; x += 1) {
            float extent = image("preserving.extent", x, y);
            if (extent > 0) {
                float object = image("preserving.object", x, y);
                color goes = image("preserving.goes", x, y);
                color facing = image("preserving.facing", x, y);
                float wanted = extent, beyond = REACH * REACH, falloff = 0;
                if (by != "variance") {
                    falloff = -.5 / (extent * extent);
                    wanted = places;
                    beyond = 9 * extent * extent;
                }
                float taken = 0, last;
                color shares = 0;
                square = 0;
                for (last = 0; last < places && taken < wanted && square <= beyond; last += 1) {
                    i = placex[last];
                    j = placey[last];
                    square = i * i + j * j;
                    if (square <= beyond && receives(x + i, y + j, object, facing) != 0) {
                        shares += exp(square * falloff)
                                * color image("preserving.seen", x + i, y + j);
                        taken += 1;
                    }
                }
                /* The pixel loses what others have got of it, rounding included. */
                color given = 0, missed = 0;
                for (k = 0; k < last; k += 1) {
                    i = placex[k];
                    j = placey[k];
                    if (i * i + j * j <= beyond && receives(x + i, y + j, object, facing) != 0) {
                        color before = image("Ci", x + i, y + j);
                        color after = before
                                    + goes * (exp((i * i + j * j) * falloff)
                                              * color image("preserving.seen", x + i, y + j)
                                              / shares);
                        setimage("Ci", x + i, y + j, after);
                        color got = (after - before) - missed;
                        color sum = given + got;
                        missed = (sum - given) - got;
                        given = sum;
                    }
                }
                setimage("Ci", x, y, color image("Ci", x, y) - given);
            }
        }
}
