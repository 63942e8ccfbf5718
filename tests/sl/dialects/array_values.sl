/* SPDX-License-Identifier: Apache-2.0 */
surface a(float w[2] = {1, 2, 3};)
{
    color c[2] = {color(1, 0, 0), color(0, 1, 0), color(0, 0, 1)};
    Ci = w[1] * c[1];
    Oi = 1;
}
