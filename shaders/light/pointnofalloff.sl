/* SPDX-License-Identifier: Apache-2.0
   pointlight without falloff: as bright at any distance. */
light pointnofalloff(float intensity = 1; /* scales the colour */
                     color lightcolor = 1;
                     point from = point "shader" (0, 0, 0);)
{
    illuminate(from)
        Cl = intensity * lightcolor;
}
