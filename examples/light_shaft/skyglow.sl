/* SPDX-License-Identifier: Apache-2.0
   The sky in a window: it shines, and lets through what comes from behind. */
surface skyglow(float radiance = 1;)
{
    Oi = 0;
    Ci = radiance * Cs;
}
