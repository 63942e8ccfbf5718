/* SPDX-License-Identifier: Apache-2.0
   The shader that docs/compiler.md follows through the compiler. */
surface
tinted(float Kd = .5;
       color tint = color(1, .5, .2);
       float fade = 0)
{
    normal Nf = normalize(N);
    color own = mix(tint, Cs, s);
    if (fade > 0)
        own *= 1 - fade * abs(Du(s));
    Oi = Os;
    Ci = Os * Kd * own * diffuse(Nf);
}
