/* SPDX-License-Identifier: Apache-2.0
   A luminous surface, for AreaLightSource in si units: the radiance that leaves P, W m^-2 sr^-1.
   It states how its power is distributed as a cone about the normal. */
light arealight(float radiance = 1;  /* along the normal */
                float intensity = 1; /* scales it, under the name that other lights have for it */
                color lightcolor = 1;
                float onesided = 1;  /* 0: both sides shine */
                float exponent = 1;  /* power of the cosine: 1 = the same radiance all around */)
{
    illuminate(P, 1, N, 180 + 180 * (1 - onesided), exponent, 1) {
        float cosine = normalize(L) . normalize(N);
        float height = max(cosine, (1 - onesided) * abs(cosine));
        Cl = 0;
        if (height > 0) {
            Cl = intensity * radiance * lightcolor;
            if (exponent != 1)
                Cl *= pow(height, exponent - 1);
        }
    }
}
