/* SPDX-License-Identifier: Apache-2.0
   A diffuse wall of bricks, each of a tone of its own and grainy, in mortar. It stands upright:
   rows go up along y of shader space, bricks along x + z. */
surface bricks(float length = .52; float height = .17; float joint = .03; /* of mortar */
               float grain = .35;  /* how much the grain of a brick shows */
               color mortar = color (.62, .60, .56);)
{
    point place = transform("shader", P);
    float rows = ycomp(place) / height;
    float row = floor(rows);
    float columns = (xcomp(place) + zcomp(place)) / length + .5 * mod(row, 2);
    float column = floor(columns);
    float inside = step(joint, (rows - row) * height) * step(joint, (columns - column) * length);
    color brick = Cs * (.55 + .6 * float cellnoise(column, row))
                * (1 - grain * float noise(place / .045));
    color body = mix(mortar, brick, inside);

    Oi = Os;
    Ci = Os * body * diffuse(faceforward(normalize(N), I));
}
