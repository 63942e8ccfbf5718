/* SPDX-License-Identifier: Apache-2.0 */
/* Rings about the z axis, jittered by noise, in the types of 1990: points for everything. */
#define snoise(x) (2 * noise(x) - 1)
surface
rings_wood(
    float Ka = 1, Kd = .8, Ks = .3, roughness = .15;
    color pale = color (.75, .5, .3);
    color dark = color (.4, .2, .1);
    float ringscale = 12, wobble = .25, grain = 40)
{
    point NN, VV, Q;
    float radius, ring, fibre;

    Q = transform("shader", P);
    Q += wobble * snoise(Q * 2);
    radius = ringscale * sqrt(xcomp(Q) * xcomp(Q) + ycomp(Q) * ycomp(Q));
    ring = mod(radius + .3 * snoise(radius), 1);
    ring = smoothstep(0, .7, ring) - smoothstep(.85, 1, ring);
    fibre = noise(xcomp(Q) * grain, ycomp(Q) * grain);
    NN = faceforward(normalize(N), I);
    VV = -normalize(I);
    Oi = Os;
    Ci = mix(pale, dark, ring) * (.85 + .15 * fibre);
    Ci = Oi * (Ci * (Ka * ambient() + Kd * diffuse(NN)) + (.3 + .7 * ring) * Ks * specular(NN, VV, roughness));
}
