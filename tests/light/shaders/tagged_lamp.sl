/* SPDX-License-Identifier: Apache-2.0 */
light tagged_lamp(float intensity = 1; output float __nondiffuse = 0; output color worn = 0;)
{
    illuminate(P, N, PI / 2) Cl = intensity;
    worn = 9;
}
