/* SPDX-License-Identifier: Apache-2.0 */
color f()
{
    extern vector I;
    extern point P;
    extern normal N;
    extern color Cs;
    return Cs * (N.I);
}
surface a()
{
    extern point P;
    Ci = f();
    Oi = Os;
}
