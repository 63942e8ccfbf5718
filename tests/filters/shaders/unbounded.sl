/* SPDX-License-Identifier: Apache-2.0 */
/* Makes what no file should hold. */
imager unbounded()
{
    float zero = 0 * xcomp(P);
    Ci = color(1 / zero, zero / zero, .5);
    alpha = 1 / zero;
}
