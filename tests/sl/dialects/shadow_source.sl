/* SPDX-License-Identifier: Apache-2.0 */
light a(string map = "m.shd"; point a = 0, b = point(0, 1, 0), c = point(0, 0, 1), d = point(0, 1, 1);)
{
    illuminate((a + b + c + d) / 4)
    {
        Cl = 1 - shadow(map, Ps, "source", a, b, c, d, "samples", 16, "gapbias", .01);
        Cl *= 1 - shadow(map, Ps, "samples", 16, "source", a);
    }
}
