/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    float f = float noise(P);
    color c = color noise(s);
    point p = point noise(P);
    vector v = vector(P);
    normal n = normal(v);
    v = vector normalize(N);
    vector w = (vector P);
    color d = color(1);
    point q = point(0);
    point r = point "world" P;
    c = color(noise(P));
    vector x = vector "shader"(1, 0, 0);
    color e = color "hsv"(1, .5, f);
    float g = float(f);
    matrix m = matrix "world" 1;
    matrix m2 = 1;
    string ss = string "abc";
    c = color v;
    p = point c;
    v = vector(color c);
    Ci = c + d + e * g;
    Oi = f;
    Ci += comp(m, 0, 0) + comp(m2, 0, 0) + comp(q, 0) + comp(r, 0) + xcomp(x) + xcomp(w) + xcomp(n);
    float aa = (float noise(P));
}
