/* SPDX-License-Identifier: Apache-2.0
   Keeps colours from being brighter than their alpha, for compositing in whole numbers. */
imager clamptoalpha()
{
    Ci = clamp(Ci, color(0, 0, 0), color(alpha, alpha, alpha));
}
