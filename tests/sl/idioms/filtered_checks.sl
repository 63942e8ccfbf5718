/* SPDX-License-Identifier: Apache-2.0 */
/* A chequerboard whose squares are averaged over the sample. */
float filteredPulse(float edge0, edge1, x, width)
{
    float from = x - width / 2, to = from + width;
    return max(0, (min(to, edge1) - max(from, edge0)) / width);
}
float periodicPulse(float x; float width)
{
    float inside = filteredPulse(.25, .75, mod(x, 1), min(width, .5));
    return mix(inside, .5, smoothstep(.5, 1.5, width));
}
surface filtered_checks(float Ka = 1, Kd = 1, frequency = 10;
                        color even = color(.9, .9, .9), odd = color(.1, .1, .1);)
{
    float ss = s * frequency, tt = t * frequency;
    float ws = max(abs(Du(ss) * du) + abs(Dv(ss) * dv), 1e-6);
    float wt = max(abs(Du(tt) * du) + abs(Dv(tt) * dv), 1e-6);
    float a = periodicPulse(ss, ws), b = periodicPulse(tt, wt);
    float check = a * (1 - b) + b * (1 - a);
    Oi = Os;
    Ci = Os * mix(even, odd, check) * (Ka * ambient() + Kd * diffuse(faceforward(normalize(N), I)));
}
