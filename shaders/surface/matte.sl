/* SPDX-License-Identifier: Apache-2.0
   An ideal diffuse surface of albedo Kd * Cs, the same from both sides. */
surface matte(
    float Ka = 1; /* share of ambient light that is sent on [0 to 1] */
    float Kd = 1; /* share of all other light, times the surface's colour: the albedo [0 to 1] */)
{
    normal facing = faceforward(normalize(N), I);

    Oi = Os;
    Ci = Os * Cs * (Ka * ambient() + Kd * diffuse(facing));
}
