/* SPDX-License-Identifier: Apache-2.0 */
float f(float x);
surface a()
{
    Ci = f(1);
    Oi = 1;
}
float f(float x)
{
    return x;
}
