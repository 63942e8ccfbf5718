/* SPDX-License-Identifier: Apache-2.0
   Light from everywhere, the same everywhere. */
light ambientlight(float intensity = 1; /* scales the colour */
                   color lightcolor = 1;)
{
    Cl = intensity * lightcolor;
}
