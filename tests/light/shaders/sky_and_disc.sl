/* SPDX-License-Identifier: Apache-2.0 */
/* Radiance 1 from a half sphere but for a disc, which has another one and may have samples of its
   own; and a sun of one direction. */
light sky_and_disc(float disc = 50, width = 6, importance = 1, sun = 0, sunImportance = 0;
                   vector axis = vector "shader" (0, 0, 1), to = vector "shader" (.6, 0, .8);)
{
    solar(3, axis, 180, 0, 1, to, width, 0, importance, axis, 0, 0, sunImportance) {
        float inDisc = normalize(L) . normalize(to) > cos(radians(width) / 2) ? 1 : 0;
        Cl = 2 * PI * mix(1, disc, inDisc);
    }
}
