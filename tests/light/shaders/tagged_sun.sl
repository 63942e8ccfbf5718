/* SPDX-License-Identifier: Apache-2.0 */
/* As lights of production renderers are: what they tell stands in output parameters. */
light tagged_sun(float intensity = 1; point from = 0, to = point "shader" (0, 0, 1);
                 output float __nondiffuse = 0; output float __nonspecular = 0;
                 output color worn = 0; output vector way = 0;)
{
    way = to - from;
    worn = .25;
    solar(way, 0) Cl = intensity;
    __nonspecular = 7;
}
