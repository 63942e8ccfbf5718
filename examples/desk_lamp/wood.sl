/* SPDX-License-Identifier: Apache-2.0
   The desk top: rings of a trunk that the board was cut from, a little glossy with wax. */
surface wood(color early = color (.48, .30, .17);
             color late = color (.30, .165, .085);
             float ringwidth = .013;  /* metres */
             float wax = .045;        /* share that the wax reflects */)
{
    normal facing = faceforward(normalize(N), I);
    vector incoming = normalize(I);
    vector mirrored = reflect(incoming, facing);

    point board = transform("shader", P);
    point bent = board + .035 * (vector noise(board * point (1.3, 5, 5)) - vector (.5, .5, .5));
    float radius = sqrt(ycomp(bent) * ycomp(bent) + .04 * (zcomp(bent) + .3));
    float ring = mod(radius / ringwidth, 1);
    float lateness = smoothstep(.35, .9, ring) * (1 - smoothstep(.93, 1, ring));
    float grain = noise(board * point (9, 420, 420));
    color body = mix(early, late, lateness) * (.8 + .4 * grain);

    color diffused = 0, shine = 0;
    illuminance(P, 2,
                facing, 180, 1, .3,
                mirrored, 120, 24, wax)
    {
        vector toLight = normalize(L);
        float cosine = facing . toLight;
        if (cosine > 0) {
            diffused += Cl * cosine;
            shine += Cl * (12.5 * pow(max(mirrored . toLight, 0), 24));
        }
    }
    Oi = Os;
    Ci = Os * Cs * ((1 - wax) * body * diffused + wax * shine);
}
