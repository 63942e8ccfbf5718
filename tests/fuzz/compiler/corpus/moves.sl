/* What moves points: displacements, deformations, a surface that moves itself. */
float hills(point p; uniform float turns) {
    float sum = 0, i;
    for (i = 1; i <= turns; i += 1) sum += abs(float noise(p * i) - .5) / i;
    return sum;
}
displacement hilly(float Km = .1, turns = 4; varying float where = 0; string space = "shader", map = "";)
{
    point p = transform(space, P);
    float h = hills(p * 3, turns) + smoothstep(.3, .3 + filterwidth(u), where);
    if (map != "") h += float texture(map, s, t);
    vector lean = ntransform(space, normalize(N)) + .1 * dPdu * Du(h) + .1 * dPdv * Dv(h);
    if (h > .5) P += Km * h * normalize(N); else P = transform(space, "current", p + Km * lean);
    N = calculatenormal(P);
    while (turns > 3) { N += .1 * normal(lean); turns -= 1; }
}
float filterwidth(float x) { return max(abs(Du(x) * du) + abs(Dv(x) * dv), 1e-6); }
transformation twisted(float angle = 1; point centre = 0;)
{
    point p = transform("object", P);
    float turn = angle * (ycomp(p) - ycomp(centre));
    P = transform("object", "current", rotate(p, turn, centre, centre + vector(0, 1, 0)));
    if (turn < 0) P += .1 * sin(8 * turn) * normalize(N);
}
surface moving(float up = .1;)
{
    point was = P;
    P += up * cellnoise(4 * u, 4 * v) * normalize(N);
    N = calculatenormal(P);
    Oi = Os * (1 - step(.9, mod(distance(was, P) * 9, 1)));
    Ci = Oi * (Cs * diffuse(faceforward(normalize(N), I)) + area(P) + trace(P, Ng));
}
