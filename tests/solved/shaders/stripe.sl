/* SPDX-License-Identifier: Apache-2.0 */
/* A wall that is dark but for a stripe of a thousandth of its width, which shines by itself. */
surface stripe(float at = .317, w = .001, Kd = .5;)
{
    Oi = Os;
    Ci = Os * ((abs(s - at) < w / 2 ? 100 : 0) + Kd * diffuse(faceforward(normalize(N), I)));
}
