/* SPDX-License-Identifier: Apache-2.0
   A diffuse body of cubes in two colours, like the squares of a chess board on each plane. */
surface tiles(float size = .4;           /* of a cube, in shader space */
              color other = color (.08, .09, .12); /* of every second one */)
{
    point cell = transform("shader", P) / size;
    /* Shifted, so that no plane of a room at whole numbers lies between two cubes. */
    float sum = floor(xcomp(cell) + .37) + floor(ycomp(cell) + .37) + floor(zcomp(cell) + .37);
    color body = mod(sum, 2) < .5 ? Cs : other;

    Oi = Os;
    Ci = Os * body * diffuse(faceforward(normalize(N), I));
}
