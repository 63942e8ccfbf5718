/* SPDX-License-Identifier: Apache-2.0
   A matte surface of albedo Kd that shines by itself: the wall of a furnace. */
surface glow(float Kd = .5;       /* albedo */
             float emission = 1;  /* radiance, W m^-2 sr^-1 */)
{
    normal facing = faceforward(normalize(N), I);

    Oi = Os;
    Ci = Os * (emission + Kd * diffuse(facing));
}
