/* SPDX-License-Identifier: Apache-2.0 */
/* Rings about random centres lift the surface. */
displacement rain_ripples(float Km = .02, freq = 20, drops = 6; float frame = 0)
{
    float i, h = 0;
    point Q = point (s, t, 0);
    for (i = 0; i < drops; i += 1) {
        point c = point (float cellnoise(i * 3.1), float cellnoise(i * 7.7 + 1), 0);
        float r = distance(Q, c);
        h += sin(2 * PI * (freq * r - frame)) * exp(-6 * r) / drops;
    }
    P += Km * h * normalize(N);
    N = calculatenormal(P);
}
