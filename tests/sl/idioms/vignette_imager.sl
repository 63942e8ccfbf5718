/* SPDX-License-Identifier: Apache-2.0 */
/* Darkens the corners and fills what is empty. */
imager vignette_imager(color bg = color(.2, .2, .25); float strength = .5)
{
    float dx = u - .5, dy = v - .5;
    float fade = 1 - strength * (dx * dx + dy * dy) * 2;
    Ci = (Ci + (1 - alpha) * bg) * fade;
    Oi = 1;
    alpha = 1;
}
