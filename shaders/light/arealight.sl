/* SPDX-License-Identifier: Apache-2.0
   A luminous surface, for AreaLightSource. In si units it sends the radiance that leaves P,
   W m^-2 sr^-1. Old scenes give an intensity instead, which falls off with the square of the
   distance. It states how its power is distributed as a cone about the normal. */
light arealight(
    float radiance = 1;   /* along the normal [0 up, W/m^2/sr in si units] */
    float intensity = 0;  /* in its place, at a distance of 1, if it is not 0 [0 up] */
    color lightcolor = 1; /* colour of the light, channel by channel [0 up] */
    float onesided = 1;   /* whether only the side that the normal is on shines [0 or 1] */
    float exponent = 1;   /* power of the cosine; 1: the same radiance all around [1 to 1000] */)
{
    illuminate(P, 1, N, 180 + 180 * (1 - onesided), exponent, 1) {
        float cosine = normalize(L) . normalize(N);
        float height = max(cosine, (1 - onesided) * abs(cosine));
        Cl = 0;
        if (height > 0) {
            Cl = radiance * lightcolor;
            if (intensity != 0)
                Cl = intensity * lightcolor / (L . L);
            if (exponent != 1)
                Cl *= pow(height, exponent - 1);
        }
    }
}
