/* SPDX-License-Identifier: Apache-2.0
   Puts the picture before a colour, as RI 3.2 (A.5) has it: colours are premultiplied. */
imager background(
    color bgcolor = 0;    /* what shows where nothing is, as displays get it [0 up] */
    color background = 0; /* the same by another renderer's name; the sum counts [0 up] */
    color color = 0;      /* and by a third one's [0 up] */)
{
    Ci += (1 - alpha) * (bgcolor + background + color);
    Oi = 1;
    alpha = 1;
}
