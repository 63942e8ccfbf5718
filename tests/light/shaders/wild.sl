/* SPDX-License-Identifier: Apache-2.0 */
/* Shines without bounds: with infinity, or with what is no number. */
surface wild(float number = 1)
{
    float zero = 0 * u;

    Oi = 1;
    Ci = number / zero;
}
