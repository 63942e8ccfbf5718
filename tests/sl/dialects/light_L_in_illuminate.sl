/* SPDX-License-Identifier: Apache-2.0 */
light a(float intensity = 1; point from = point "shader"(0, 0, 0);)
{
    illuminate(from)
    {
        Cl = intensity / (L.L);
        L = normalize(L);
    }
}
