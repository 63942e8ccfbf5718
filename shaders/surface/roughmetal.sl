/* SPDX-License-Identifier: Apache-2.0
   Rough metal: microfacets with the GGX distribution and Smith's height-correlated masking,
   scattering once. Its cones: the core of the lobe, its long tail, and a weak hemisphere. */
surface roughmetal(float reflectance = 1; /* of each facet, in the surface's colour */
                   float alpha = .1;      /* GGX width; not the square root of it */)
{
    normal facing = faceforward(normalize(N), I);
    vector toEye = -normalize(I);
    vector mirrored = reflect(-toEye, facing);
    float cosEye = max(facing . toEye, 1e-4);
    float width = max(alpha * alpha, 1e-6);
    float core = .45 / width;
    color reflected = 0;

    illuminance(P, 3,
                mirrored, 180, core, .62,
                mirrored, 180, max(core / 8, 1), .3,
                facing, 180, 1, .08)
    {
        vector toLight = normalize(L);
        float cosLight = facing . toLight;
        if (cosLight > 0) {
            float cosHalf = facing . normalize(toEye + toLight);
            float spread = cosHalf * cosHalf * (width - 1) + 1;
            float facets = width / (PI * spread * spread);
            float masking = cosEye * sqrt(width + (1 - width) * cosLight * cosLight)
                          + cosLight * sqrt(width + (1 - width) * cosEye * cosEye);
            reflected += Cl * (PI * reflectance * facets * cosLight / (2 * masking));
        }
    }
    Oi = Os;
    Ci = Os * Cs * reflected;
}
