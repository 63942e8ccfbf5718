/* SPDX-License-Identifier: Apache-2.0
   A rolled metal plate, brushed along its length: a rough mirror over a faint diffuse film. It
   says where light matters to it: much in a narrow cone about the mirror direction, a little
   everywhere. */
surface plate(float Ks = .88;      /* share that the rough mirror reflects, face on */
              float Kd = .04;      /* albedo of the film */
              float size = 40;     /* exponent of the lobe */
              float cone = 80;     /* full angle of its cone, degrees */
              float brush = .22;   /* how much the strokes of the brush change Ks */)
{
    normal facing = faceforward(normalize(N), I);
    vector mirrored = reflect(normalize(I), facing);
    color reflected = 0;

    /* Strokes half a millimetre wide and some centimetres long, along z of the plate. */
    point place = transform("shader", P);
    float strokes = .5 * (noise(ycomp(place) * 1800, zcomp(place) * 24)
                        + noise(ycomp(place) * 500, zcomp(place) * 9));
    float polish = Ks * (1 - brush * strokes);

    illuminance(P, 2,
                mirrored, cone, size, polish,
                facing, 180, 1, Kd)
    {
        vector toLight = normalize(L);
        float cosine = facing . toLight;
        if (cosine > 0) {
            /* The lobe's integral against Cl is 1: (n + 1) / 2 cos^n over the solid angle. */
            float lobe = .5 * (size + 1) * pow(max(mirrored . toLight, 0), size);
            reflected += Cl * (polish * lobe + Kd * cosine);
        }
    }
    Oi = Os;
    Ci = Os * Cs * reflected;
}
