/* SPDX-License-Identifier: Apache-2.0 */
/* Attributes of the primitive: user:wear in red, Sides and ShadingRate beside it. */
surface worn()
{
    float wear = .125, sides = 0, rate = 0;

    attribute("user:wear", wear);
    attribute("Sides", sides);
    attribute("Ri:ShadingRate", rate);
    Oi = 1;
    Ci = color(wear + sides * 10 + rate * 100, 0, 0);
}
