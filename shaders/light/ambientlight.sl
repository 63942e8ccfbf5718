/* SPDX-License-Identifier: Apache-2.0
   Light from everywhere, the same everywhere. */
light ambientlight(
    float intensity = 1;  /* scales the colour [0 up] */
    color lightcolor = 1; /* colour of the light, channel by channel [0 up] */)
{
    Cl = intensity * lightcolor;
}
