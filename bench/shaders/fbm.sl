/* SPDX-License-Identifier: Apache-2.0
   Eight octaves of noise. */
surface fbm()
{
    point at = 8 * P;
    float sum = 0, weight = .5, octave;
    for (octave = 0; octave < 8; octave += 1) {
        sum += weight * float noise(at);
        at *= 2;
        weight *= .5;
    }

    Oi = Os;
    Ci = sum;
}
