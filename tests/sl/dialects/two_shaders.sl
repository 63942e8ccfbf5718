/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    Ci = 1;
    Oi = 1;
}
displacement b()
{
    P += N;
    N = calculatenormal(P);
}
light c()
{
    solar() Cl = 1;
}
