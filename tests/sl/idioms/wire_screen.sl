/* SPDX-License-Identifier: Apache-2.0 */
/* Holes: what is not wire is not there. */
surface
wire_screen(float Ks = .5, Kd = .5, Ka = 1, roughness = .1; color specularcolor = 1;
            float density = .25, frequency = 20;)
{
    varying point Nf;
    if (mod(s * frequency, 1) < density || mod(t * frequency, 1) < density) {
        Nf = faceforward(normalize(N), I);
        Oi = 1.0;
        Ci = Os * (Cs * (Ka * ambient() + Kd * diffuse(Nf)) + specularcolor * Ks * specular(Nf, -normalize(I), roughness));
    } else {
        Oi = 0.0;
        Ci = 0.0;
    }
}
