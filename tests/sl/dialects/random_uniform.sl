/* SPDX-License-Identifier: Apache-2.0 */
surface a(uniform float r = 1;)
{
    uniform float q = random();
    Ci = q * r;
    Oi = 1;
    uniform color c = color random();
    Ci += c;
}
