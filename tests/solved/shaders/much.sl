/* SPDX-License-Identifier: Apache-2.0 */
/* More than any surface can do. */
surface much(float Kd = 3;)
{
    Oi = Os;
    Ci = Os * Kd * diffuse(faceforward(normalize(N), I)) * (s > .8 ? sqrt(-1) : 1);
}
