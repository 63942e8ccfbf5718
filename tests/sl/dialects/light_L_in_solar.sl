/* SPDX-License-Identifier: Apache-2.0 */
light a(float intensity = 1; point to = point "shader"(0, 0, 1);)
{
    solar(to, 0)
    {
        L = vector(0, 0, 1);
        Cl = intensity;
    }
}
