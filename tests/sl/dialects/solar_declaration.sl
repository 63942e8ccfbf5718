/* SPDX-License-Identifier: Apache-2.0 */
light a(float k = 1;)
{
    solar()
    float b = k;
    Cl = b;
}
