/* SPDX-License-Identifier: Apache-2.0
   Fades to the background with depth, linearly: what is nearer than `mindistance` is as it is, what
   is beyond `maxdistance` is gone. Both are depths as depth() tells them, 0 at the near and 1 at the
   far clipping plane. As RI 3.2, 16.3, has it. */
volume depthcue(
    float mindistance = 0; /* what is nearer is as it is [0 to 1: the near and far clipping
                              plane] */
    float maxdistance = 1; /* what is beyond is gone [mindistance to 1, likewise] */
    color background = 0;  /* what it goes to [0 up] */)
{
    float hidden = clamp((depth(P) - mindistance) / (maxdistance - mindistance), 0, 1);
    Ci = mix(Ci, background, hidden);
    Oi = mix(Oi, color 1, hidden);
}
