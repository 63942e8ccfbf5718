/* SPDX-License-Identifier: Apache-2.0 */
/* March along the ray, and gather what lights bring. */
#define MINSTEPS 3
volume beam_smoke(float density = .2, integstart = 0, integend = 20, stepsize = 1, maxsteps = 30;
                  color scatter = 1;)
{
    color Cv = 0, Ov = 0, dC, dO;
    point Worigin = P - I, Q;
    vector direction = normalize(I);
    float end = min(length(I), integend), d = integstart + random() * stepsize, step, taken = 0;
    while (d < end && taken < maxsteps) {
        Q = Worigin + d * direction;
        color li = 0;
        illuminance(Q)
            li += Cl;
        dO = 1 - exp(-density * stepsize);
        Cv += (1 - Ov) * dO * li * scatter;
        Ov += (1 - Ov) * dO;
        d += stepsize;
        taken += 1;
    }
    Ci = Cv + (1 - Ov) * Ci;
    Oi = Ov + (1 - Ov) * Oi;
}
