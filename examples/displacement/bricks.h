/* SPDX-License-Identifier: Apache-2.0
   A wall of bricks in running bond, as its surface and its displacement see it alike: courses,
   worn edges, chipped corners, mortar that was raked out, stones that differ. All lengths are in
   units of (ss, tt), whichever they are. */
#ifndef BRICKS_H
#define BRICKS_H

/* Fractal noise between -1 and 1, of so many layers. */
float layered(point p; float layers)
{
    point q = p;
    float sum = 0, size = 1, sizes = 0, k;
    for (k = 0; k < layers; k += 1) {
        sum += size * (2 * float noise(q) - 1);
        sizes += size;
        size *= .5;
        q = 2 * q + vector "current" (.31, .77, .53);
    }
    return sum / sizes;
}

/* Where on the wall: which brick, and where on it from its middle. */
void locate(float ss, tt, width, height, joint;
            output float column, row, x, y, number;)
{
    float course = height + joint, step = width + joint;
    row = floor(tt / course);
    /* Every other course is moved by half a brick; each a little more, as masons do. */
    float along = ss / step + .5 * mod(row, 2) + .06 * (float cellnoise(row + .5) - .5);
    column = floor(along);
    number = column + 31 * row;
    x = (along - column - .5) * step;
    y = (tt / course - row - .5) * course;
}

/* How far within a rounded rectangle of these half sides a place lies; below 0 outside. */
float within(float x, y, halfWidth, halfHeight, corner)
{
    float a = abs(x) - (halfWidth - corner), b = abs(y) - (halfHeight - corner);
    float beyond = sqrt(max(a, 0) * max(a, 0) + max(b, 0) * max(b, 0));
    return corner - beyond - min(max(a, b), 0);
}

/* What a brick is like: numbers between 0 and 1 that differ from brick to brick. */
float likeness(float number, which)
{
    return float cellnoise(number + .5, 17 * which + .5);
}

/* How much is broken off a brick: a chip at one corner of some. */
float chip(float number, x, y, halfWidth, halfHeight; point p;)
{
    float broken = smoothstep(.55, .95, likeness(number, 5));
    float cx = halfWidth * (likeness(number, 6) < .5 ? -1 : 1);
    float cy = halfHeight * (likeness(number, 7) < .5 ? -1 : 1);
    float size = halfHeight * mix(.2, .9, likeness(number, 8));
    float away = sqrt((x - cx) * (x - cx) + (y - cy) * (y - cy));
    away += .3 * size * layered(p * 6, 3);
    return broken * (1 - smoothstep(.7 * size, size, away));
}

/* Small holes, where pebbles and straw were burnt out. */
float pits(point p; float amount)
{
    float n = float noise(p * 24), m = float noise(p * 55 + vector "current" (3, 7, 1));
    return smoothstep(1 - .35 * amount, 1, n) + .5 * smoothstep(1 - .3 * amount, 1, m);
}

/* The wall's relief: 0 in the deepest mortar, 1 on the face of a brick; `brick` is 1 on bricks and
   0 in mortar, with the worn edge between. */
float relief(float ss, tt, width, height, joint, wear;
             output float brick, number;)
{
    float column, row, x, y;
    locate(ss, tt, width, height, joint, column, row, x, y, number);
    point p = point "current" (ss / height, tt / height, .37 * number);

    /* The outline of the stone wanders, and its edge is worn round. */
    float wander = wear * .05 * height * layered(p * 3, 3);
    float inside = within(x, y, width / 2, height / 2, .12 * height) + wander;
    brick = smoothstep(0, .08 * height, inside);
    float round = smoothstep(0, (.06 + .12 * wear) * height, inside);

    /* The face: tilted as it was laid, bulged, rough and pitted, chipped. */
    float tilt = .10 * ((likeness(number, 1) - .5) * x / width +
                        (likeness(number, 2) - .5) * y / height);
    float proud = .12 * (likeness(number, 3) - .5);
    float rough = .06 * layered(p * 5, 4) + .03 * layered(p * 21, 2);
    float face = .9 + tilt + proud + rough - .18 * pits(p, wear);
    face -= .6 * chip(number, x, y, width / 2, height / 2, p);

    /* The mortar: raked out to a hollow, with grains of sand. */
    float hollow = smoothstep(-joint / 2, 0, inside);
    point q = point "current" (ss / height, tt / height, 5);
    float mortar = .18 + .22 * hollow + .10 * layered(q * 9, 4) + .05 * layered(q * 40, 2);

    return mix(mortar, max(face, mortar), round);
}

#endif
