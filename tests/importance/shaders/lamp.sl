/* SPDX-License-Identifier: Apache-2.0
   A lamp of even radiance on its outside, of the category "lamps". */
light lamp(float radiance = 1; string __category = "lamps";)
{
    illuminate(P, 1, N, 180, 1, 1) {
        Cl = 0;
        if (normalize(L) . normalize(N) > 0)
            Cl = radiance;
    }
}
