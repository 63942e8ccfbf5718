/* SPDX-License-Identifier: Apache-2.0
   The lobe of "lobe", found by directions alone: drawn by itself from the density that the renderer
   states, with its defensive share (5 % all around, 5 % by the cosine), and followed as a mirror's. */
vector around(vector axis; float cosine; float turn)
{
    vector other = abs(xcomp(axis)) < .7 ? vector "current" (1, 0, 0) : vector "current" (0, 1, 0);
    vector s = normalize(axis ^ other), t = axis ^ s;
    return sqrt(max(0, 1 - cosine * cosine)) * (cos(turn) * s + sin(turn) * t) + cosine * axis;
}

surface lobebydirections(float exponent = 100;)
{
    normal facing = faceforward(normalize(N), I);
    vector mirrored = normalize(reflect(normalize(I), facing));
    float choice = random(), share = random(), turn = 2 * PI * random();
    float side = random() < .5 ? 1 : -1;

    vector direction = around(mirrored, pow(share, 1 / (exponent + 1)), turn);
    if (choice > .95)
        direction = around(side * vector(facing), sqrt(share), turn);
    else if (choice > .9)
        direction = around(side * vector(facing), share, turn);

    float cosine = max(0, mirrored . direction), height = facing . direction;
    float lobe = (exponent + 1) / (2 * PI) * pow(cosine, exponent);
    float density = .9 * lobe + .05 / (4 * PI) + .05 * abs(height) / (2 * PI);
    color sum = 0;
    illuminance(P, 1, direction, 0, 0, 1)
        sum += Cl;
    Oi = Os;
    Ci = height > 0 ? Os * sum * (lobe / density) : 0;
}
