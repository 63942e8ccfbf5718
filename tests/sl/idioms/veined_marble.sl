/* SPDX-License-Identifier: Apache-2.0 */
/* Turbulence bends planes of colour, which a spline gives. */
surface veined_marble(float Ka = .3, Kd = .7, Ks = .4, roughness = .08;
                      float veins = 3, octaves = 6; string space = "shader")
{
    point PP = transform(space, P) * veins;
    float sum = 0, f = 1, i;
    for (i = 0; i < octaves; i += 1) {
        sum += abs(.5 - noise(PP * f)) / f;
        f *= 2;
    }
    color stone = spline(clamp(2 * sum, 0, 1),
        color(.9, .9, .92), color(.9, .9, .92), color(.8, .8, .85), color(.6, .6, .7),
        color(.35, .35, .45), color(.7, .7, .75), color(.2, .2, .3), color(.1, .1, .15));
    normal Nf = faceforward(normalize(N), I);
    Oi = Os;
    Ci = Os * (stone * (Ka * ambient() + Kd * diffuse(Nf)) + Ks * specular(Nf, -normalize(I), roughness));
}
