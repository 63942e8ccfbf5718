/* SPDX-License-Identifier: Apache-2.0 */
/* A point light that says L itself, without illuminate. */
light pointing(float intensity = 1; point from = point "shader" (0, 0, 0))
{
    L = Ps - from;
    Cl = intensity / (L . L);
}
