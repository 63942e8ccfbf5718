/* SPDX-License-Identifier: Apache-2.0 */
light a(float intensity = 1;)
{
    normal n = faceforward(normalize(N), I);
    illuminate(P, n, 1.57)
    {
        Cl = intensity * Cs * abs(normalize(Ns).normalize(L));
    }
}
