/* SPDX-License-Identifier: Apache-2.0 */
/* A height field by sines, shaded with a bent normal instead of displaced. */
surface knit_fabric(float Ka = .1, Kd = .9, freq = 40, depth = .4)
{
    float ss = s * freq, tt = t * freq;
    float hs = sin(2 * PI * ss) * sin(PI * tt), ht = cos(2 * PI * ss + PI * floor(tt));
    vector T = normalize(dPdu), B = normalize(dPdv);
    normal Nb = normalize(normalize(N) + depth * (hs * T + ht * B));
    normal Nf = faceforward(Nb, I, N);
    float pores = smoothstep(-1, .2, hs + ht);
    Oi = mix(color .7, color 1, pores) * Os;
    Ci = Oi * Cs * (Ka * ambient() + Kd * diffuse(Nf)) * (.4 + .6 * pores);
}
