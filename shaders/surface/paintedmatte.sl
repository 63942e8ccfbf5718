/* SPDX-License-Identifier: Apache-2.0
   Matte paint of albedo Kd * Cs that states its importance: a cosine lobe about the normal. */
surface paintedmatte(float Kd = .5; /* albedo, times the surface's colour [0 to 1] */)
{
    normal facing = faceforward(normalize(N), I);
    color reflected = 0;

    illuminance(P, 1, facing, 180, 1, Kd)
        reflected += Kd * Cl * max(facing . normalize(L), 0);
    Oi = Os;
    Ci = Os * Cs * reflected;
}
