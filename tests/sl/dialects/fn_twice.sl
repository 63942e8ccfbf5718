/* SPDX-License-Identifier: Apache-2.0 */
float f(float x)
{
    return x;
}
float f(float x)
{
    return 2 * x;
}
surface a()
{
    Ci = f(s);
    Oi = 1;
}
