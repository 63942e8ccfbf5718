/* SPDX-License-Identifier: Apache-2.0
   A diffuse surface that hears the lamps of one category alone. */
surface choosy(float Kd = .5;)
{
    normal facing = faceforward(normalize(N), I);
    color sum = 0;
    illuminance("wanted", P, facing, PI / 2)
        sum += Cl * max(0, normalize(L) . facing);
    Oi = Os;
    Ci = Os * Cs * Kd * sum;
}
