/* SPDX-License-Identifier: Apache-2.0 */
/* Fog by the letter of the book. */
volume
old_fog(float distance = 1; color background = 0)
{
    color d;
    d = 1 - exp(-length(I) / distance);
    Ci = mix(Ci, background, d);
    Oi = mix(Oi, color(1, 1, 1), d);
}
