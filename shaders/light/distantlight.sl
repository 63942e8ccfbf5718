/* SPDX-License-Identifier: Apache-2.0
   Parallel light, as from the sun. In si units, intensity is the irradiance on a surface that
   faces the light, W m^-2. */
light distantlight(float intensity = 1; /* scales the colour */
                   color lightcolor = 1;
                   point from = point "shader" (0, 0, 0); /* the light comes from here ... */
                   point to = point "shader" (0, 0, 1);   /* ... and goes there */)
{
    solar(to - from, 0)
        Cl = intensity * lightcolor;
}
