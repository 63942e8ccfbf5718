/* SPDX-License-Identifier: Apache-2.0 */
light a()
{
    N = normalize(N);
    illuminate(P, N, PI / 2)
    {
        Cl = 1 / (L.L);
    }
}
