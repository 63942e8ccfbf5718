/* SPDX-License-Identifier: Apache-2.0 */
/* A radiance from all directions of a cone, the same from each, or as much as the cosine with its
   axis says. */
light even_sky(float radiance = 1, angle = 180, cosine = 0; vector axis = vector "shader" (0, 0, 1);
               string __category = ""; float __nonspecular = 0;)
{
    float half = radians(angle) / 2;
    solar(1, axis, angle, 0, 1)
        Cl = 2 * PI * (1 - cos(half)) * radiance *
             (cosine > 0 ? max(0, normalize(L) . normalize(axis)) : 1);
}
