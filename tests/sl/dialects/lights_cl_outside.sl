/* SPDX-License-Identifier: Apache-2.0 */
light a(float intensity = 1; color lightcolor = 1;)
{
    Cl = intensity * lightcolor;
    L = 0;
    Ol = 1;
}
