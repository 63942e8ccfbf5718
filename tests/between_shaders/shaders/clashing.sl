/* SPDX-License-Identifier: Apache-2.0 */
/* Output parameters that are called as what the compiler itself has of surfaces. */
surface clashing(output varying float g = 0; output varying color L = 0; output varying color Cl = 0;
                 output varying vector dPdu = 0; output varying float alpha = 0;
                 output varying float completed = 0; output varying color Ca = 0;
                 output varying color Ce = 0; output varying color CiOfCi = 0;)
{
    g = .125;
    L = color(1, 2, 3);
    Cl = color(4, 5, 6);
    dPdu = vector(7, 8, 9);
    alpha = .25;
    completed = .375;
    Ca = .625;
    Ce = .75;
    CiOfCi = .875;
    Oi = Os;
    Ci = .5 * diffuse(normalize(N));
}
