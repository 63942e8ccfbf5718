/* SPDX-License-Identifier: Apache-2.0 */
/* Defaults that are computed: from others, from the point, from spaces. */
surface noisy_defaults(float Kd = .6, Ks = 1 - Kd; float scale = 2 * Kd + 1;
                       point centre = point "shader" (0, 0, 0) + vector "shader" (0, 0, 1);
                       vector across = normalize(dPdu);
                       color tint = mix(color(1, 0, 0), color(0, 0, 1), Kd);
                       string base = "tex", name = concat(base, ".tx");)
{
    float r = distance(P, centre) * scale;
    float streak = sin(40 * (across . (P - centre)));
    Oi = Os;
    Ci = Os * tint * (Kd * diffuse(faceforward(normalize(N), I)) + Ks * noise(r, streak));
    if (name == "tex.tx")
        Ci *= Cs;
}
