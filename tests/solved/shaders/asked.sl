/* SPDX-License-Identifier: Apache-2.0 */
/* The two terms of the paper's equation 7: E as the solution has it, light loops for the rest. */
surface asked(float Kd = .5, emission = 0;)
{
    Oi = Os;
    Ci = Os * (emission + Kd * (irradiance(P, -I) / PI + diffuse(faceforward(normalize(N), I))));
}
