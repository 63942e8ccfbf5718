/* SPDX-License-Identifier: Apache-2.0 */
/* Two tones: not affine in the light. */
surface toon()
{
    color light = diffuse(faceforward(normalize(N), I));
    Oi = Os;
    Ci = comp(light, 0) > .5 ? Cs : color(0);
}
