/* Rays in every place: loops, conditions, defaults, functions, lights; gather with all its outputs. */
color seen(point p; vector d; uniform float n) {
    float far = 0;
    color here = 0;
    gather("illuminance", p, d, .5, n, "ray:length", far, "surface:Ci", here)
        here += 1 / (1 + far);
    else
        return color "hsv" (.6, .5, 1);
    return here / n;
}
surface asking(float samples = 4, cone = PI / 3; color sky = .2; point aim = point "world" (0, 1, 0);
               output varying float hidden = 0;)
{
    normal Nf = faceforward(normalize(N), I), there = 0;
    vector way = 0, R = normalize(reflect(I, Nf));
    point at = 0, o = 0;
    float far = 0, met = 0, i, a[3] = {1, 2, 3}, where[2] = {0, 0};
    color body = 0, glow = 0, sum = 0;
    for (i = 0; i < 3; i += 1) {
        gather("", P, Nf, cone * a[i], samples, "bias", .001, "maxdist", 5 * a[i],
               "distribution", "uniform", "ray:direction", way, "ray:origin", o, "primitive:P", at,
               "primitive:N", there, "surface:Cs", body, "surface:Os", glow, "primitive:s", where[0]) {
            if (distance(at, o) > 4) continue;
            met += way . there;
            if (met > 9) break;
            sum += body * glow * where[0];
        } else sum += sky;
        a[i] = met;
    }
    hidden = occlusion(P, Nf, samples, "coneangle", cone, "environmentdir", way);
    if (u < .5 && rayhittest(P, R, at, way) < 1e20)
        hidden += depth(at) * Du(met);
    illuminance(P, Nf, cone) {
        if (comp(transmission(P, P + L), 1) < .5) continue;
        sum += Cl * max(0, normalize(L) . Nf) * visibility(P, aim);
    }
    while (far < 2) { far += 1; sum += trace(P, R + far * vector(Nf)) * indirectdiffuse(P, Nf, 4); }
    Oi = Os * mix(color 1, seen(P, -R, 3), .2);
    Ci = Oi * (Cs * sum * (1 - hidden) + fulltrace(P, R, far, at, way, o, way) + raydepth());
}
light screened(float size = .1; point from = point "shader" (0, 0, 0); color lightcolor = 1;)
{
    illuminate(from) {
        Cl = lightcolor / (L . L) * transmission(Ps, from, "samples", 3, "samplecone", size / length(L));
        if (occlusion(Ps, Ns, 2) > .5) Cl *= .5;
    }
}
