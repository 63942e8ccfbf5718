/* SPDX-License-Identifier: Apache-2.0
   A lamp of even radiance on one side that says of itself which loops may hear it. */
light taggedlamp(float radiance = 1;
                 string __category = "";
                 float __nondiffuse = 0;
                 float __nonspecular = 0;)
{
    illuminate(P, 1, N, 180, 1, 1) {
        Cl = 0;
        if (normalize(L) . normalize(N) > 0)
            Cl = radiance;
    }
}
