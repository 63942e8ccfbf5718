/* SPDX-License-Identifier: Apache-2.0
   The paper's Phong surface that emits what it does not reflect: with a the albedo at the angle of
   view, 1 - a. In a room of nothing else every direction has radiance 1.

   a = Kd + Ks / pi * (integral over the lune of directions above both the surface and the plane
   across the mirror direction R, of (R . w)^exp). In polar coordinates about the lune's axis this
   is a product: (integral of sin^(exp+1) over 0..pi) times (integral of cos^exp from theta - pi/2
   to pi/2). Both by their recurrences, for even exponents. */
surface glowphong(float Kd = .4; float Ks = .6; float exponent = 2;)
{
    normal facing = faceforward(normalize(N), I);
    vector mirrored = reflect(normalize(I), facing);
    color reflected = 0;

    illuminance(P, 2, facing, 180, 1, Kd, mirrored, 180, exponent, 2 * Ks / (exponent + 1))
    {
        vector toLight = normalize(L);
        float cosine = facing . toLight;
        if (cosine > 0)
            reflected += Cl * (Kd * cosine + Ks * pow(max(mirrored . toLight, 0), exponent));
    }

    float theta = acos(clamp(-normalize(I) . facing, 0, 1));
    float from = theta - PI / 2;
    float across = PI / 2 - from;   /* integral of cos^n, from n = 0 */
    float along = 2;                /* integral of sin^(n+1), from n = 0 */
    float n;
    for (n = 2; n <= exponent; n += 2) {
        across = (n - 1) / n * across - pow(cos(from), n - 1) * sin(from) / n;
        along *= n / (n + 1);
    }
    Oi = Os;
    Ci = Os * (1 - Kd - Ks / PI * along * across + reflected);
}
