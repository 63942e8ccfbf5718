/* SPDX-License-Identifier: Apache-2.0 */
f(float x)
{
    return x * 2;
}
g(float x)
{
    printf("x");
}
h(color c;)
{
    return c;
}
surface a()
{
    Ci = f(s) + h(Cs);
    Oi = Os;
    g(2);
}
