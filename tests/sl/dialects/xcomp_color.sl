/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    float grey = (xcomp(Cs) + ycomp(Cs) + zcomp(texture("a.tx"))) / 3;
    Ci = grey * xcomp(N);
    Oi = 1;
}
