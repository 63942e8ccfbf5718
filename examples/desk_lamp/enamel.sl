/* SPDX-License-Identifier: Apache-2.0
   Glazed ceramic: a diffuse body in the surface's colour, a clear coat that reflects more at
   grazing angles. */
surface enamel(float Kd = .75;    /* albedo of the body, times the surface's colour */
               float coat = .04;  /* share that the coat reflects, face on */
               float size = 160;  /* exponent of its lobe */)
{
    normal facing = faceforward(normalize(N), I);
    vector incoming = normalize(I);
    vector mirrored = reflect(incoming, facing);
    float grazing = 1 + facing . incoming;
    float share = coat + (1 - coat) * pow(max(grazing, 0), 5);
    color body = 0, gloss = 0;

    illuminance(P, 2,
                facing, 180, 1, Kd * (1 - share),
                mirrored, 60, size, share)
    {
        vector toLight = normalize(L);
        float cosine = facing . toLight;
        if (cosine > 0) {
            body += Cl * cosine;
            gloss += Cl * (.5 * (size + 1) * pow(max(mirrored . toLight, 0), size));
        }
    }
    Oi = Os;
    Ci = Os * ((1 - share) * Kd * Cs * body + share * gloss);
}
