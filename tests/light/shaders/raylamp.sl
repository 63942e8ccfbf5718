/* SPDX-License-Identifier: Apache-2.0 */
/* A lamp that says itself where its light does not get. */
light raylamp(float intensity = 1; point from = point "shader" (0, 0, 0))
{
    illuminate(from)
        Cl = intensity * transmission(Ps, from) / (L . L);
}
