/* SPDX-License-Identifier: Apache-2.0
   Six octaves of noise choose a colour of a spline; unlit. */
surface marble(float frequency = 4; /* veins a metre */)
{
    point at = frequency * P;
    float turbulence = 0, size = 1, octave;
    for (octave = 0; octave < 6; octave += 1) {
        turbulence += abs(.5 - float noise(size * at)) / size;
        size *= 2;
    }

    Oi = Os;
    Ci = Os * spline(4 * turbulence - .5,
                     color(.25, .25, .35), color(.25, .25, .35), color(.20, .20, .30),
                     color(.20, .20, .30), color(.20, .20, .30), color(.25, .25, .35),
                     color(.25, .30, .45), color(.30, .35, .50), color(.35, .40, .55),
                     color(.30, .30, .50), color(.25, .30, .40), color(.20, .20, .30),
                     color(.20, .20, .30));
}
