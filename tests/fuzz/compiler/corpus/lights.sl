light spot(float intensity = 1; color lightcolor = 1; point from = point "shader" (0, 0, 0),
    to = point "shader" (0, 0, 1); float angle = radians(30), soft = radians(5), beam = 2;)
{
    uniform vector A = (to - from) / length(to - from);
    uniform float outer = cos(angle), inside = cos(angle - soft);
    illuminate(from, A, angle) {
        float c = L . A / length(L);
        float attenuation = pow(c, beam) / (L . L);
        attenuation *= smoothstep(outer, inside, c);
        Cl = attenuation * intensity * lightcolor * (1 + .2 * noise(Ps * 4));
    }
}
light sky(color top = color(.2, .4, 1); float turbid = 2; string space = "world";)
{
    vector up = vtransform(space, "current", vector(0, 1, 0));
    solar(up, PI / 2) {
        float h = clamp(normalize(-L) . up, 0, 1);
        Cl = mix(color(1, 1, 1), top, pow(h, 1 / turbid));
        if (h <= 0) Cl = 0;
    }
}
light area(float intensity = 1; float bands = 3;)
{
    illuminate(P, N, PI / 2) {
        Cl = intensity * step(.5, mod(s * bands, 1)) * spline(t, 0, 0, .5, 1, 1);
        Ol = 1;
    }
}
light fill(float intensity = .1) { Cl = intensity * (1 + ambient()); }
