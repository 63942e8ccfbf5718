/* SPDX-License-Identifier: Apache-2.0
   Light from a point, the same in all directions, falling off with the square of the distance.
   In si units, intensity is radiant intensity, W sr^-1. */
light pointlight(
    float intensity = 1;                   /* scales the colour [0 up; W/sr in si units] */
    color lightcolor = 1;                  /* colour of the light, channel by channel [0 up] */
    point from = point "shader" (0, 0, 0); /* where the light stands [anywhere] */)
{
    illuminate(from)
        Cl = intensity * lightcolor / (L . L);
}
