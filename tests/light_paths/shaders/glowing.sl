/* SPDX-License-Identifier: Apache-2.0 */
/* A wall that sends a radiance of its own, and some of what comes. */
surface glowing(float radiance = 1, Kd = .5;)
{
    Oi = 1;
    Ci = radiance + Kd * diffuse(faceforward(normalize(N), I));
}
