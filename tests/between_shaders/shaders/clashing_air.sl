/* SPDX-License-Identifier: Apache-2.0 */
volume clashing_air(output varying color CiOfCi = 0; output varying float g = 0;)
{
    CiOfCi = color(1, 2, 3);
    g = .125;
    Ci *= .5;
}
