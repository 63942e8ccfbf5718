/* SPDX-License-Identifier: Apache-2.0 */
/* The light that arrives `back` before the end of the segment. */
volume at_the_end(float back = 0)
{
    color light = 0;
    illuminance(P - back * normalize(I)) light += Cl;
    Ci = light;
    Oi = 1;
}
