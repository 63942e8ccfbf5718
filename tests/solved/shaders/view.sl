/* SPDX-License-Identifier: Apache-2.0 */
/* Reflects more the flatter it is looked at, and shines with the rest: radiance 1 in a furnace. */
surface view()
{
    normal Nf = faceforward(normalize(N), I);
    float a = .8 - .5 * abs(normalize(I) . Nf);
    Oi = Os;
    Ci = Os * (1 - a + a * diffuse(Nf));
}
