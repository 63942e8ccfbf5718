/* SPDX-License-Identifier: Apache-2.0 */
uniform float f(uniform float x)
{
    return x * 2;
}
varying color g(float x)
{
    return color(x, x, x);
}
surface a(float k = 1;)
{
    Ci = g(f(k));
    Oi = 1;
}
