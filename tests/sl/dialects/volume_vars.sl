/* SPDX-License-Identifier: Apache-2.0 */
volume a(float d = 1;)
{
    color c = Cs * noise(s, t);
    Ci = mix(Ci, c, 1 - exp(-length(I) / d));
    normal n = N;
    Oi = mix(Oi, 1, zcomp(n) * 0);
}
