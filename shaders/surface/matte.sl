/* SPDX-License-Identifier: Apache-2.0
   An ideal diffuse surface of albedo Kd * Cs, the same from both sides. */
surface matte(float Ka = 1; /* share of ambient light */
              float Kd = 1; /* share of all other light */)
{
    normal facing = faceforward(normalize(N), I);

    Oi = Os;
    Ci = Os * Cs * (Ka * ambient() + Kd * diffuse(facing));
}
