/* SPDX-License-Identifier: Apache-2.0
   Bumps by N alone: points stay. */
displacement bumps()
{
    N = normalize(N) + .4 * sin(8 * xcomp(P)) * vector "current" (1, 0, 0);
}
