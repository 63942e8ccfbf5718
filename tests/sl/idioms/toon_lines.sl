/* SPDX-License-Identifier: Apache-2.0 */
/* Cartoon: tones by thresholds on the light, black where the surface turns away. */
surface toon_lines(float Ka = .1, Kd = 1, tones = 3, outline = .25; color ink = 0)
{
    normal Nf = faceforward(normalize(N), I);
    vector V = -normalize(I);
    color light = 0;
    illuminance(P, Nf, PI / 2)
        light += Cl * (normalize(L) . Nf);
    float level = (comp(light, 0) + comp(light, 1) + comp(light, 2)) / 3;
    float tone = ceil(level * tones) / tones;
    float edge = step(outline, V . Nf);
    Oi = Os;
    Ci = Os * mix(ink, Cs * (Ka + Kd * tone), edge);
}
