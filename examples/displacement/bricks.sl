/* SPDX-License-Identifier: Apache-2.0
   Bricks of clays that were burnt more and less, in lime mortar; "brickrelief" gives them relief. */
#include "bricks.h"

/* Of one brick: its clay, how it was burnt, and what has settled on it. */
color clay(float number, ss, tt, height; color pale, burnt;)
{
    point p = point "current" (ss / height, tt / height, .37 * number);
    float fire = likeness(number, 9) + .35 * layered(p, 4);
    color body = mix(pale, burnt, smoothstep(.2, .9, fire));
    /* Some stood nearest to the fire and are almost black, some are yellow. */
    body = mix(body, .25 * burnt, smoothstep(.9, .97, likeness(number, 10)));
    body = mix(body, color (.62, .50, .33), .7 * smoothstep(.88, .96, likeness(number, 11)));
    /* Grains, and streaks where it was wiped. */
    body *= 1 + .25 * layered(p * 14, 3);
    body *= 1 + .12 * layered(point "current" (ss / height * 2, tt / height * 17, number), 2);
    return body;
}

color mortarColor(float ss, tt, height; color lime;)
{
    point p = point "current" (ss / height, tt / height, 9);
    float sand = float noise(p * 60);
    color grain = mix(color (.35, .28, .2), color (.9, .87, .8), float noise(p * 45 + 3));
    return mix(lime * (1 + .2 * layered(p * 3, 4)), grain, .5 * smoothstep(.62, .7, sand));
}

/* Lime that rain has washed out, and dirt that has gathered below. */
color weathered(color base; float ss, tt, depth, amount;)
{
    point p = point "current" (2 * ss, .6 * tt, 3);
    float bloom = smoothstep(.15, .7, layered(p * 2, 5));
    float soot = smoothstep(0, .8, .4 + layered(point "current" (ss, tt, 11) * 1.5, 4));
    color washed = mix(base, color (.78, .76, .72), .45 * amount * bloom * bloom);
    return washed * (1 - amount * (.35 * soot + .3 * (1 - depth)));
}

surface bricks(float Ka = 1, Kd = .9;
               float width = .24, height = .07, joint = .012;
               float wear = .6;
               color pale = color (.55, .27, .17), burnt = color (.34, .10, .07);
               color lime = color (.58, .55, .49);)
{
    float brick, number;
    float out = relief(s, t, width, height, joint, wear, brick, number);
    color stone = clay(number, s, t, height, pale, burnt);
    color base = mix(mortarColor(s, t, height, lime), stone, brick);
    base = weathered(base, s, t, clamp(out, 0, 1), wear);

    normal facing = faceforward(normalize(N), I);
    Oi = Os;
    Ci = Os * Cs * base * (Ka * ambient() + Kd * diffuse(facing));
}
