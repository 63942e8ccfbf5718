/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    point Nf, V, D;
    Nf = faceforward(normalize(N), I);
    V = normalize(-I);
    D = Nf ^ V;
    point R = reflect(I, Nf);
    Ci = diffuse(Nf) + specular(Nf, V, .1);
    Oi = length(D - R);
    point h = normalize(normalize(V) + Nf);
    float x = h.Nf;
    Ci *= x;
}
