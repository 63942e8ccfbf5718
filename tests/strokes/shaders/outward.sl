/* SPDX-License-Identifier: Apache-2.0
   Green is how far N, or Ng, is from the direction away from the origin of shader space, or from
   its x axis; red how far P is from that radius. */
surface outward(float radius = 1, axis = 0, which = 0;)
{
    vector d = transform("shader", P) - point (0, 0, 0);
    normal m = ntransform("shader", which == 0 ? N : Ng);
    if (axis == 1)
        setxcomp(d, 0);
    Oi = Os;
    Ci = Os * color (abs(length(d) - radius), length(normalize(m) - normalize(d)), 0);
}
