/* SPDX-License-Identifier: Apache-2.0 */
light a(float intensity = 1; color lightcolor = 1; point from = point "shader"(0, 0, 0);)
{
    L = Ps - from;
    Cl = intensity * lightcolor / (L.L);
}
