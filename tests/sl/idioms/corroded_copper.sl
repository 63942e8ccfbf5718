/* SPDX-License-Identifier: Apache-2.0 */
/* Two materials by a mask of turbulence and of height; functions of points and floats by one name. */
float turb(point Q; float n) { float i, a = 1, r = 0; point q = Q; for (i = 0; i < n; i += 1) { r += a * abs(2 * float noise(q) - 1); q *= 2; a /= 2; } return r; }
float turb(float x; float n) { return turb(point (x, 0, 0), n); }
surface corroded_copper(float Ka = .3, Kd = .4, Ks = .7, roughness = .15, amount = .5;
                        color copper = color(.75, .4, .25), patina = color(.2, .55, .45))
{
    point Q = transform("shader", P);
    float mask = smoothstep(amount - .1, amount + .1, turb(Q * 3, 5) - .2 * turb(t * 4, 3));
    normal Nf = faceforward(normalize(N), I);
    color metalPart = copper * Ks * specular(Nf, -normalize(I), roughness) + copper * Ka * ambient();
    color dullPart = patina * (Ka * ambient() + Kd * diffuse(Nf));
    Oi = Os;
    Ci = Os * mix(metalPart, dullPart, mask);
}
