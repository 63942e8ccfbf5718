/* What shaders ask of each other, in every type, and outputs of every type. */
surface hearing(float own[3] = {1, 2, 3}; string name = "here"; output varying color parts[2] = {0, 1};
                output varying normal way = 0; output matrix frame = 1; output varying float count = 0;)
{
    float k = 0, ks[3] = {0, 0, 0}, found = 0;
    color c = 0;
    point p = 0;
    vector v = 0;
    normal n = 0;
    matrix m = 1;
    string tag = "", other = "b";
    found = displacement("k", k) + displacement("ks", ks) + atmosphere("c", c) + incident("p", p);
    found += opposite("v", v) + surface("own", ks) + attribute("user:n", n) + option("user:m", m);
    illuminance("a|b", P, N, PI / 2) {
        if (lightsource("tag", tag) == 1 && (tag == "key" || tag == other)) {
            parts[0] += Cl;
            if (lightsource("ks", ks) == 1) c += ks[1] * Cl;
        } else if (lightsource("p", p) == 1)
            way = normal(p - P);
        count += lightsource("nosuch", k);
    }
    if (displacement("tag", tag) == 1)
        parts[1] = match("k.*", tag) * c * k;
    frame = m * matrix "world" 2;
    Oi = Os;
    Ci = Os * Cs * (c + found + ks[floor(u * 3)] + length(v)) * (way . N + determinant(frame));
}
volume hearing_air(float k = .5; color c = .2; output varying float path = 0;)
{
    string tag = "none";
    float far = length(I), reach = 0;
    path = far * (surface("reach", reach) + displacement("k", reach));
    Ci = Ci * exp(-far * k) + c * path;
    if (surface("tag", tag) == 1 && tag != "none") Oi = mix(Oi, color 1, reach);
}
light telling(string tag = "key"; float ks[3] = {1, 2, 3}; point p = point "shader" (0, 1, 0);
              output varying color told = 1;)
{
    float reach = 1;
    solar(vector "shader" (0, 0, 1), .1) {
        if (surface("reach", reach) == 1) Cl = told * ks[1] / reach;
        else Cl = told * (tag == "key" ? 1 : ks[2]);
    }
}
