/* SPDX-License-Identifier: Apache-2.0
   Uniform fog: in every `distance` metres it keeps all but 1/e of the light that comes through, and
   shows the colour of the fog in its place. As RI 3.2, 16.3, has it. */
volume fog(
    float distance = 1;   /* the way on which all but 1/e of the light is lost [above 0, length] */
    color background = 0; /* what the fog shows in its place [0 up, W/m^2/sr in si units] */)
{
    float clear = distance > 0 ? exp(-length(I) / distance) : 0;
    Ci = mix(background, Ci, clear);
    Oi = mix(color 1, Oi, clear);
}
