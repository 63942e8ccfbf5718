/* SPDX-License-Identifier: Apache-2.0
   Puts the picture before a colour, as RI 3.2 (A.5) has it: colours are premultiplied. */
imager background(color bgcolor = 0; /* what shows where nothing is, as displays get it */
                  color background = 0; /* other renderers' names for it: the sum counts */
                  color color = 0;)
{
    Ci += (1 - alpha) * (bgcolor + background + color);
    Oi = 1;
    alpha = 1;
}
