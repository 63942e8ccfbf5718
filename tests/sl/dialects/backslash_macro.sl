/* SPDX-License-Identifier: Apache-2.0 */
#define snoise(p) (2 * (float noise(p)) - 1)
#define fBm(p, o) (snoise(p) + snoise((p)*2) * .5 * o)
#define CAT(a, b) a##b
#define STR(x) #x
surface a()
{
    Ci = fBm(P, 2) + snoise(P);
    float CAT(x, y) = 1;
    Oi = xy;
    string q = STR(foo bar);
}
