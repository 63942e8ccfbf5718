/* SPDX-License-Identifier: Apache-2.0
   A lobe about the mirrored direction, found by light samples and directions together, or, with a
   category that only the lamps have, by light samples alone. */
surface lobe(float exponent = 100; string heard = "";)
{
    normal facing = faceforward(normalize(N), I);
    vector mirrored = normalize(reflect(normalize(I), facing));
    color sum = 0;
    illuminance(heard, P, 1, mirrored, 180, exponent, 1) {
        vector toLight = normalize(L);
        float cosine = mirrored . toLight;
        if (cosine > 0 && facing . toLight > 0)
            sum += Cl * ((exponent + 1) / 2 * pow(cosine, exponent));
    }
    Oi = Os;
    Ci = Os * sum;
}
