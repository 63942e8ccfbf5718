/* SPDX-License-Identifier: Apache-2.0
   A gloss about the mirror direction that states its own cone, and a matte base. */
surface stated(float Kd = .3; float Ks = .4; float exponent = 20)
{
    normal Nf = faceforward(normalize(N), I);
    vector R = normalize(reflect(normalize(I), Nf));
    color sum = 0;
    illuminance(P, 2, Nf, 180, 1, Kd, R, 180, exponent, Ks) {
        vector Ln = normalize(L);
        sum += Cl * (Kd * max(Ln . Nf, 0) + Ks * pow(max(Ln . R, 0), exponent));
    }
    Oi = Os;
    Ci = Os * Cs * sum;
}
