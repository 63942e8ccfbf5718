/* SPDX-License-Identifier: Apache-2.0
   A rolled metal plate, brushed by use: a rough mirror over a faint diffuse film. It says where
   light matters to it: much in a narrow cone about the mirror direction, a little everywhere. */
surface plate(float Ks = .72;      /* share that the rough mirror reflects, face on */
              float Kd = .06;      /* albedo of the film */
              float size = 60;     /* exponent of the lobe */
              float cone = 70;     /* full angle of its cone, degrees */)
{
    normal facing = faceforward(normalize(N), I);
    vector mirrored = reflect(normalize(I), facing);
    color reflected = 0;

    illuminance(P, 2,
                mirrored, cone, size, Ks,
                facing, 180, 1, Kd)
    {
        vector toLight = normalize(L);
        float cosine = facing . toLight;
        if (cosine > 0) {
            /* The lobe's integral against Cl is Ks: (n + 1) / 2 cos^n over the solid angle. */
            float lobe = .5 * (size + 1) * pow(max(mirrored . toLight, 0), size);
            reflected += Cl * (Ks * lobe + Kd * cosine);
        }
    }
    Oi = Os;
    Ci = Os * Cs * reflected;
}
