surface matrices(matrix m = 1; vector v = vector(0, 0, 1);)
{
    point here = transform(m, P);
    vector across = v ^ vector(N);
    float d = distance(here, P) + length(across) + determinant(m);
    color c = color "hsv" (d, .5, clamp(s, 0, 1));
    string name = format("%f %p", d, here);
    if (name == "x" || d != d) printf("%s\n", name);
    Oi = 1 - smoothstep(0, .1, abs(s - .5));
    Ci = Oi * c * (1 + area(P) + Du(s) + step(.5, t)) + spline(t, color 0, color 0, color 1, color 1);
}
