/* SPDX-License-Identifier: Apache-2.0
   The lamp's luminous panel: one side shines, its power follows the cosine about the normal. */
light lampglow(float watts = 20;       /* radiant flux of the whole panel */
               float area = .01;       /* of the panel, square metres */
               color tint = color (1, .83, .62);)
{
    /* A Lambertian panel of flux F and area A has the radiance F / (pi A). */
    color radiance = tint * watts / (PI * area * comp(tint, 0));

    illuminate(P, 1, N, 180, 1, 1) {
        Cl = 0;
        if (L . N > 0)
            Cl = radiance;
    }
}
