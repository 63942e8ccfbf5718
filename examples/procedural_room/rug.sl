/* SPDX-License-Identifier: Apache-2.0 */
/* A woven rug in checks with a border. */
surface rug(
    float checks = 12;                      /* across */
    color one = color(.62, .10, .08), other = color(.75, .66, .48), border = color(.06, .10, .30);)
{
    float check = mod(floor(s * checks) + floor(t * checks), 2);
    float inner = step(.06, min(min(s, 1 - s), min(t, 1 - t)));
    color wool = mix(border, mix(other, one, check), inner);
    Oi = Os;
    Ci = Os * wool * (.8 + .25 * noise(s * 400, t * 400)) * diffuse(faceforward(normalize(N), I));
}
