/* SPDX-License-Identifier: Apache-2.0 */
/* A lamp in the units of RI: each of its positions sends the same whatever the distance, to the
   side of the normal. */
light classic_lamp(float intensity = 1)
{
    illuminate(P, N, PI / 2) Cl = intensity;
}
