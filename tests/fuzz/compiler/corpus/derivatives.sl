float filterwidth(float x) { return max(abs(Du(x) * du) + abs(Dv(x) * dv), 1e-6); }
color checks(float ss, tt, wide) {
    float w = filterwidth(ss) + filterwidth(tt);
    float a = smoothstep(.4 - w, .4 + w, mod(ss, 1)), b = smoothstep(.4, .6, mod(tt, 1));
    return mix(color(wide, .2, .1), color "rgb" (.9, .9, .8), a * (1 - b) + b * (1 - a));
}
surface derivatives(float scale = 6, roughness = .1, Km = .05; string project = "st";)
{
    point PP = transform("object", P) * scale;
    vector across = Du(PP) ^ Dv(PP);
    float bumps = Km * (snoise(PP) + fBm(PP));
    normal Nn = calculatenormal(P + bumps * normalize(N));
    vector V = -normalize(I), T = normalize(dPdu);
    float spread = sqrt(area(PP)), turn = atan(T . V, across . V) + Deriv(s, t);
    color base = checks(s * scale, t * scale, spread);
    float a[3] = {0, 0, 0};
    a[0] = Du(bumps); a[1] = Dv(turn); a[2] = filterwidth(spread);
    if (project == "st" || depth(P) > 1) base *= cellnoise(floor(s * 9), floor(t * 9));
    Oi = Os * (1 - .1 * random());
    Ci = Oi * (Cs * base * (ambient() + diffuse(Nn)) + specular(Nn, V, roughness)
        + phong(Nn, V, 20) + trace(P, refract(normalize(I), Nn, 1 / 1.5)) * a[1] + irradiance(P, Nn));
}
float snoise(point p) { return noise(p) * 2 - 1; }
float fBm(point p) {
    float sum = 0, amplitude = 1, i;
    point q = p;
    for (i = 0; i < 4; i += 1) { sum += amplitude * snoise(q); amplitude *= .5; q *= 2; }
    return sum + pnoise(p, point(3, 3, 3));
}
