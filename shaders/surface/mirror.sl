/* SPDX-License-Identifier: Apache-2.0
   A perfect mirror: all importance in one direction. */
surface mirror(float Kr = 1; /* share of light that is reflected [0 to 1] */)
{
    normal facing = faceforward(normalize(N), I);
    vector mirrored = reflect(normalize(I), facing);
    color reflected = 0;

    illuminance(P, 1, mirrored, 0, 0, Kr)
        reflected += Kr * Cl;
    Oi = Os;
    Ci = Os * Cs * reflected;
}
