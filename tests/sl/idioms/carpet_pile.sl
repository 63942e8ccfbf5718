/* SPDX-License-Identifier: Apache-2.0 */
/* Pile: noise in brightness, and more light at grazing angles. */
surface carpet_pile(float Kd = .6, Ka = .1, scuff = 1, nap = 5, swirl = 1)
{
    color pileInfluence = 0;
    float ws = s * 100, wt = t * 100;
    float speckle = float noise(ws, wt);
    float stotal = .25 + .75 * float noise(s * 4 * scuff, t * 4 * scuff);
    normal Nf = faceforward(normalize(N), I);
    vector V = -normalize(I);
    color C = 0;
    illuminance(P, Nf, radians(90)) {
        vector LN = normalize(L);
        float sinL = sqrt(1 - pow(LN . Nf, 2)), sinV = sqrt(1 - (V . Nf) * (V . Nf));
        C += Kd * Cl * (LN . Nf + nap * .05 * swirl * pow(sinL, 3) * sinV);
    }
    Oi = Os;
    Ci = Os * Cs * (Ka * ambient() + C) * mix(.6, 1, speckle) * stotal + pileInfluence;
}
