/* SPDX-License-Identifier: Apache-2.0
   Fades to the background with depth, linearly: what is nearer than `mindistance` is as it is, what
   is beyond `maxdistance` is gone. Both are depths as depth() tells them, 0 at the near and 1 at the
   far clipping plane. As RI 3.2, 16.3, has it. */
volume depthcue(float mindistance = 0, maxdistance = 1; color background = 0;)
{
    float hidden = clamp((depth(P) - mindistance) / (maxdistance - mindistance), 0, 1);
    Ci = mix(Ci, background, hidden);
    Oi = mix(Oi, color 1, hidden);
}
