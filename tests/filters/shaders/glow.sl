/* SPDX-License-Identifier: Apache-2.0 */
/* A matte surface that shines besides. */
surface glow(float Kd = 1;)
{
    Oi = Os;
    Ci = Os * (2 + Cs * Kd * diffuse(faceforward(normalize(N), I)));
}
