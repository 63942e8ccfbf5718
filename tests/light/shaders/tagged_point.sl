/* SPDX-License-Identifier: Apache-2.0 */
light tagged_point(float intensity = 1; point from = 0; output float __nondiffuse = 0;
                   output float distance = 0; output color worn = 0;)
{
    illuminate(from) {
        distance = length(L);
        Cl = intensity / (distance * distance);
    }
    worn = 9;
}
