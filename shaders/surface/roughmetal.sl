/* SPDX-License-Identifier: Apache-2.0 */
#define OUTSET_1 .65
#define OUTSET_2 1.45
#define OUTSET_3 4.2

/* Where a facet mirrors the eye to that is tilted towards it; `aside` is the eye's direction along
   the surface. */
vector tilted(normal facing; vector toEye, aside; float tilt)
{
    vector facet = normalize(facing + tilt * aside);
    return 2 * (toEye . facet) * facet - toEye;
}

/* Directions below the surface are of no use. */
float above(normal facing; vector axis; float share)
{
    return facing . axis > 0 ? share : 0;
}

/* Rough metal: microfacets with the GGX distribution and Smith's height-correlated masking,
   scattering once.
   Seen aslant, its lobe is a ridge in the plane of incidence, as much narrower across as the cosine
   says. Cones are round: seven of them stand along the ridge, where facets tilted by some times
   alpha mirror the eye to, each about as wide as the ridge is across or as far as the next; face on
   they are about one axis and of several widths. An eighth holds the long tail. Their numbers
   minimise the second moment of what a direction is worth, at alpha = .01. */
surface roughmetal(float reflectance = 1; /* of each facet, times the surface's colour [0 to 1] */
                   float alpha = .1;      /* GGX width; not the square root of it [.001 to 1] */)
{
    normal facing = faceforward(normalize(N), I);
    vector toEye = -normalize(I);
    vector mirrored = reflect(-toEye, facing);
    float cosEye = max(facing . toEye, 1e-4);
    float width = max(alpha * alpha, 1e-6);
    float lean = sqrt(width);
    color reflected = 0;

    vector aside = toEye - cosEye * facing;
    vector near1 = tilted(facing, toEye, aside, lean * OUTSET_1);
    vector near2 = tilted(facing, toEye, aside, lean * OUTSET_2);
    vector near3 = tilted(facing, toEye, aside, lean * OUTSET_3);
    vector far1 = tilted(facing, toEye, aside, -lean * OUTSET_1);
    vector far2 = tilted(facing, toEye, aside, -lean * OUTSET_2);
    vector far3 = tilted(facing, toEye, aside, -lean * OUTSET_3);
    float slant = cosEye * cosEye;
    float exponent0 = max(1, 1 / (width * (.066 + 1.1 * slant)));
    float exponent1 = max(1, 1 / (width * (.11 + 2.6 * slant)));
    float exponent2 = max(1, 1 / (width * (.5 + 16 * slant)));
    float exponent3 = max(1, 1 / (width * (9 + 85 * slant)));
    float share2 = .135 - .07 * cosEye, share3 = .06 - .05 * cosEye;
    /* The tail of wide lobes is the hemisphere. */
    float tail = 1 / (900 * width);
    vector tailAxis = tail > 1 ? mirrored : vector(facing);
    float tailShare = tail > 1 ? .03 : min(.03 + width, .5);

    illuminance(P, 8,
                mirrored, 180, exponent0, .23 + .24 * cosEye,
                near1, 180, exponent1, above(facing, near1, .19),
                far1, 180, exponent1, above(facing, far1, .19),
                near2, 180, exponent2, above(facing, near2, share2),
                far2, 180, exponent2, above(facing, far2, share2),
                near3, 180, exponent3, above(facing, near3, share3),
                far3, 180, exponent3, above(facing, far3, share3),
                tailAxis, 180, max(tail, 1), tailShare)
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
