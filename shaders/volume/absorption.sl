/* SPDX-License-Identifier: Apache-2.0
   A clear substance with a colour: of white light `transmittance` is left after `distance` metres,
   and more or less of it where the way is shorter or longer (Beer and Lambert). Meant as the
   Interior of glass and water. It is as opaque as what is seen through it, and gives no light. */
volume absorption(
    color transmittance = 1; /* what is left of white light after that distance [0 to 1] */
    float distance = 1;      /* the way that this is said of [above 0, length] */)
{
    float ways = length(I) / distance;
    Ci *= color(pow(comp(transmittance, 0), ways), pow(comp(transmittance, 1), ways),
                pow(comp(transmittance, 2), ways));
}
