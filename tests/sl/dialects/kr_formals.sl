/* SPDX-License-Identifier: Apache-2.0 */
surface a(Ka, Kd, c)
float Ka = 1, Kd = .5;
color c = 1;
{
    Ci = Ka * Kd * c;
    Oi = Os;
}
