/* SPDX-License-Identifier: Apache-2.0 */
/* A thread about the shaft, smooth at its ends. */
displacement threaded_bolt(float Km = .1, frequency = 5, phase = 0, offset = 0, dampzone = .05, roundness = 2)
{
    float magnitude;
    magnitude = (sin(PI * 2 * (t * frequency + s + phase)) + offset) * Km;
    if (t > (1 - dampzone))
        magnitude *= (1.0 - t) / dampzone;
    else if (t < dampzone)
        magnitude *= t / dampzone;
    magnitude = sign(magnitude) * pow(abs(magnitude), 1 / roundness);
    P += normalize(N) * magnitude;
    N = calculatenormal(P);
}
