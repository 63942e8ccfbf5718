/* SPDX-License-Identifier: Apache-2.0
   pointlight without falloff: as bright at any distance. */
light pointnofalloff(
    float intensity = 1;                   /* scales the colour [0 up; has no unit that a lamp
                                              could have] */
    color lightcolor = 1;                  /* colour of the light, channel by channel [0 up] */
    point from = point "shader" (0, 0, 0); /* where the light stands [anywhere] */)
{
    illuminate(from)
        Cl = intensity * lightcolor;
}
