/* SPDX-License-Identifier: Apache-2.0 */
light wildlight(float number = 1; point from = 0)
{
    illuminate(from) Cl = number / (0 * xcomp(L));
}
