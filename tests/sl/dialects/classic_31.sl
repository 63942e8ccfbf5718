/* SPDX-License-Identifier: Apache-2.0 */
surface wood31(float Ka = 1, Kd = .75, Ks = .4; float roughness = .1; color specularcolor = 1;
               float ringscale = 15;
               color lightwood = color(0.69, 0.44, 0.25), darkwood = color(0.35, 0.22, 0.08);
               float grainy = 1)
{
    point NN, V;
    point PP;
    float y, z, r;
    PP = transform("shader", P);
    PP += noise(PP);
    y = ycomp(PP);
    z = zcomp(PP);
    r = sqrt(y * y + z * z);
    r *= ringscale;
    r += abs(noise(r));
    r -= floor(r);
    r = smoothstep(0, .8, r) - smoothstep(.83, 1.0, r);
    Ci = mix(lightwood, darkwood, r);
    Oi = Os;
    NN = faceforward(normalize(N), I);
    V = -normalize(I);
    Ci = Oi * (Ci * (Ka * ambient() + Kd * diffuse(NN)) +
               (0.3 * r + 0.7) * specularcolor * Ks * specular(NN, V, roughness));
}
