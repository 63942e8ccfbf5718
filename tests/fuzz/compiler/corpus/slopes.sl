float width(float x) { return abs(Du(x) * du) + abs(Dv(x) * dv); }
color edge(color c) { return Du(c) * du + Dv(c) * dv; }
surface slopes(float scale = 3, turns = 4;)
{
    float a[4] = {0, 0, 0, 0}, i, x = sin(scale * s) * noise(scale * P), wide = 0;
    for (i = 0; i < turns; i += 1) {
        x = x * t + u * comp(Cs, 1);
        a[mod(i, 4)] = x + ycomp(Ng);
        if (x > .5) wide += width(x * i); else x += pow(abs(u), 1.5) * log(2 + v);
    }
    x = sin(x) + Du(x); x = exp(-x * x) + Dv(x); x = sqrt(4 + x) * Du(x);
    vector bend = Du(N) ^ Dv(normalize(Ng));
    color c = edge(Cs * (1 - Os)) + color noise(P + scale * vector(Cs)) * Dv(a[floor(turns * .5)]);
    setcomp(c, 1, Du(comp(c, 0)) + Dv(atan(x, 1 + t)));
    Oi = Os;
    Ci = Oi * (c + wide + length(bend) + Du(Dv(s * t * u)) + Deriv(comp(Cs, 2), t)) * diffuse(N + bend);
}
