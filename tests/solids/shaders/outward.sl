/* SPDX-License-Identifier: Apache-2.0
   Bright where the outside is seen; the normal, of unit length, in the other colours. */
surface outward()
{
    normal n = normalize(N);
    Oi = 1;
    Ci = color (n . I < 0 ? 1 : 0, .5 + .5 * xcomp(n), 0);
}
