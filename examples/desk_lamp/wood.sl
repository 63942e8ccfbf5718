/* SPDX-License-Identifier: Apache-2.0
   The desk top: boards sawn along x from different places of a trunk, a little glossy with wax.
   Lengths in metres. */
surface wood(color early = color (.50, .33, .20);
             color late = color (.33, .19, .105);
             float ringwidth = .011;  /* between two winters, where the saw cut them square */
             float boardwidth = .145;
             float wax = .04;         /* share that the wax reflects */)
{
    normal facing = faceforward(normalize(N), I);
    vector incoming = normalize(I);
    vector mirrored = reflect(incoming, facing);

    point place = transform("shader", P);
    float board = floor(zcomp(place) / boardwidth);
    float across = mod(zcomp(place), boardwidth) - .5 * boardwidth;
    /* Each board from another part of the trunk: its axis runs below, hardly tilted. */
    float along = xcomp(place) + 3.7 * cellnoise(board);
    float sway = .022 * (noise(along * 2.1, board * 9.3) - .5);
    float depth = .02 + .05 * cellnoise(board + 31) + .018 * along;
    float beside = across + sway + .09 * (cellnoise(board + 57) - .5);
    float radius = sqrt(beside * beside + depth * depth)
                 + .004 * noise(along * 9, across * 60);
    float ring = mod(radius / ringwidth, 1);
    float lateness = smoothstep(.25, .85, ring) * (1 - smoothstep(.9, 1, ring));
    float fibres = noise(along * 14, zcomp(place) * 900);
    float pores = smoothstep(.62, .8, noise(along * 40, zcomp(place) * 1600));
    float tone = .88 + .24 * cellnoise(board + 5);
    color body = tone * mix(early, late, lateness) * (.84 + .32 * fibres) * (1 - .25 * pores);
    /* The joint between two boards. */
    float edge = .5 * boardwidth - abs(across);
    body *= mix(.35, 1, smoothstep(.0004, .0014, edge));

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
