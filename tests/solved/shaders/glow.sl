/* SPDX-License-Identifier: Apache-2.0 */
/* A furnace's wall: what it does not reflect of a uniform field it sends itself. */
surface glow(float Kd = .5, emission = .5;)
{
    Oi = Os;
    Ci = Os * (emission + Kd * diffuse(faceforward(normalize(N), I)));
}
