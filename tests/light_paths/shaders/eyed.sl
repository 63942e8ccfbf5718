/* SPDX-License-Identifier: Apache-2.0
   A gloss about the bisector of light and camera, by E: the camera's, whoever looks. */
surface eyed(float Kd = .4; float Ks = .4; float exponent = 10)
{
    normal Nf = faceforward(normalize(N), I);
    vector toEye = normalize(E - P);
    color sum = 0;
    illuminance(P, Nf, PI / 2) {
        vector Ln = normalize(L);
        sum += Cl * (Ln . Nf) * (Kd + Ks * pow(max(normalize(Ln + toEye) . Nf, 0), exponent));
    }
    Oi = Os;
    Ci = Os * Cs * sum;
}
