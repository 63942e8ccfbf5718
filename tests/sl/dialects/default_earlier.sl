/* SPDX-License-Identifier: Apache-2.0 */
surface a(float Kd = .5; float Ks = 1 - Kd; color c = color(Kd, Ks, 0); float fr = noise(Kd * 3);)
{
    Ci = c * fr;
    Oi = 1;
}
