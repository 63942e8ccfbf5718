/* SPDX-License-Identifier: Apache-2.0 */
float f(a, b)
float a;
float b;
{
    return a * b;
}
point g(p; float k) point p;
{
    return p * k;
}
surface a()
{
    Ci = f(1, 2) * xcomp(g(P, 1));
    Oi = Os;
}
