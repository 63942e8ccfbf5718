/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    color c = pow(Cs, 2);
    color d = pow(Cs, color(1, 2, 3));
    Ci = c + d;
    Oi = Os;
    if (Cs > 0.5)
        Ci = 1;
    if (Cs < color(1, 1, 1))
        Ci = 0;
    if (c != d)
        Oi = 1;
    if (Cs >= 1)
        Oi = 0;
}
