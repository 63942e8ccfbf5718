/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    point PP = Ps;
    Ci = noise(PP);
    Oi = 1;
}
