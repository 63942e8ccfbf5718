/* SPDX-License-Identifier: Apache-2.0
   Parallel light, as from the sun. In si units, intensity is the irradiance on a surface that
   faces the light, W m^-2. */
light distantlight(
    float intensity = 1;                   /* scales the colour [0 up; of irradiance, W/m^2 in si
                                              units] */
    color lightcolor = 1;                  /* colour of the light, channel by channel [0 up] */
    point from = point "shader" (0, 0, 0); /* light comes from here ... [anywhere] */
    point to = point "shader" (0, 0, 1);   /* ... and goes there; what counts is the direction
                                              [anywhere] */)
{
    solar(to - from, 0)
        Cl = intensity * lightcolor;
}
