/* SPDX-License-Identifier: Apache-2.0
   The Phong model that the paper uses to show the extended illuminance(): a diffuse lobe about
   the normal and a power of the cosine about the mirror direction. It states both as cones, each
   with the share of uniform light that it reflects. Not energy conserving at grazing angles. */
surface phong(float Kd = .4; /* diffuse albedo [0 to 1] */
              float Ks = .6; /* height of the specular lobe [0 to 1] */
              float exp = 2; /* its exponent: the higher, the narrower [0 to 10000] */)
{
    normal facing = faceforward(normalize(N), I);
    vector mirrored = reflect(normalize(I), facing);
    color reflected = 0;

    illuminance(P, 2,
                facing, 180, 1, Kd,
                mirrored, 180, exp, 2 * Ks / (exp + 1))
    {
        vector toLight = normalize(L);
        float cosine = facing . toLight;
        if (cosine > 0) {
            float lobe = pow(max(mirrored . toLight, 0), exp);
            reflected += Cl * (Kd * cosine + Ks * lobe);
        }
    }
    Oi = Os;
    Ci = Os * Cs * reflected;
}
