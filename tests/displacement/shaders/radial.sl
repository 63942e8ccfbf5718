/* SPDX-License-Identifier: Apache-2.0
   Green is how far the normals N, or Ng, are from radial ones; blue how far P is from a sphere of
   that radius. */
surface radial(float radius = 1.2, which = 0;)
{
    vector d = transform("shader", P) - point (0, 0, 0);
    normal m = ntransform("shader", which == 0 ? N : Ng);
    Oi = 1;
    Ci = color (abs(length(d) - radius), length(normalize(m) - normalize(d)), 0);
}
