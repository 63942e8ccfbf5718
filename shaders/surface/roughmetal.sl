/* SPDX-License-Identifier: Apache-2.0
   Rough metal: microfacets with the GGX distribution and Smith's height-correlated masking,
   scattering once. Its cones: the core of the lobe, its long tail in one or two steps, and a weak
   hemisphere. */
surface roughmetal(float reflectance = 1; /* of each facet, in the surface's colour */
                   float alpha = .1;      /* GGX width; not the square root of it */)
{
    normal facing = faceforward(normalize(N), I);
    vector toEye = -normalize(I);
    vector mirrored = reflect(-toEye, facing);
    float cosEye = max(facing . toEye, 1e-4);
    float width = max(alpha * alpha, 1e-6);
    float core = .45 / width;
    /* Seen aslant the lobe is narrower across than along, so its core is drawn in half way. */
    float slant = sqrt(max(cosEye, .05));
    float tail = core > 64 ? .06 : 0; /* what wide lobes leave to the hemisphere */
    color reflected = 0;

    illuminance(P, 4,
                mirrored, 180, core / slant, .62,
                mirrored, 180, max(core / 8, 1), .3 - tail,
                mirrored, 180, max(core / 64, 1), tail,
                facing, 180, 1, .08)
    {
        vector toLight = normalize(L);
        float cosLight = facing . toLight;
        if (cosLight > 0) {
            vector halfway = normalize(toEye + toLight);
            float cosHalf = facing . halfway;
            vector sinHalf = facing ^ halfway; /* 1 - cosHalf^2 would lose narrow lobes' digits */
            float spread = cosHalf * cosHalf * width + sinHalf . sinHalf;
            float facets = width / (PI * spread * spread);
            float masking = cosEye * sqrt(width + (1 - width) * cosLight * cosLight)
                          + cosLight * sqrt(width + (1 - width) * cosEye * cosEye);
            reflected += Cl * (PI * reflectance * facets * cosLight / (2 * masking));
        }
    }
    Oi = Os;
    Ci = Os * Cs * reflected;
}
