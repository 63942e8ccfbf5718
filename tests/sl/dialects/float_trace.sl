/* SPDX-License-Identifier: Apache-2.0 */
surface a(float Kr = .5;)
{
    vector R = reflect(normalize(I), normalize(N));
    float d = trace(P, R);
    color seen = Kr * trace(P, R);
    Ci = d < 1 ? seen : trace(P, R);
    Ci += Kr * trace(P, R);
    Oi = 1;
}
