/* SPDX-License-Identifier: Apache-2.0 */
/* Highlights that stretch across the brush strokes (after a model of the early nineties). */
color wardish(normal Nn; vector V, xdir; float xrough, yrough)
{
    extern point P;
    vector X = normalize(xdir - (xdir . Nn) * Nn), Y = Nn ^ X;
    color C = 0;
    float cosr = max(V . Nn, .0001);
    illuminance("-specularoff", P, Nn, PI / 2) {
        float nonspec = 0;
        if (nonspec < 1) {
            vector LN = normalize(L), H = normalize(LN + V);
            float rho = exp(-2 * (pow(X . H / xrough, 2) + pow(Y . H / yrough, 2)) / (1 + H . Nn));
            C += Cl * rho * (LN . Nn) / sqrt(max(cosr * (LN . Nn), .0001)) / (4 * xrough * yrough);
        }
    }
    return C;
}
surface brushed_anisotropy(float Ka = .2, Kd = .2, Ks = .3, xroughness = .1, yroughness = .4)
{
    normal Nf = faceforward(normalize(N), I);
    Oi = Os;
    Ci = Os * Cs * (Ka * ambient() + Kd * diffuse(Nf)
         + Ks * wardish(Nf, -normalize(I), dPdu, xroughness, yroughness));
}
