/* SPDX-License-Identifier: Apache-2.0
   Two tones, by what a diffuse surface would send on: not affine in the light. */
surface toon(float Kd = .5;
             float threshold = .5;
             color dark = color(.25, .25, .25);
             color bright = color(.75, .75, .75))
{
    normal facing = faceforward(normalize(N), I);
    color lit = Kd * diffuse(facing);

    Oi = Os;
    if (comp(lit, 1) > threshold)
        Ci = Os * bright;
    else
        Ci = Os * dark;
}
