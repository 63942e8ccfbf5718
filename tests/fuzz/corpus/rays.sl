/* Everything that a surface may ask by rays. */
surface rays(float samples = 4, cone = 1.2; string what = "";)
{
    normal Nf = faceforward(normalize(N), I);
    vector R = reflect(normalize(I), Nf), way = 0, bent = 0, normalThere = 0;
    float hits = 0, far = 0, long = 0;
    point there = 0;
    color found = 0, radiance = 0, missed = 0;
    gather("illuminance", P, Nf, cone, samples, "distribution", "cosine", "maxdist", 9, "bias", .001,
           "ray:length", far, "ray:direction", way, "surface:Cs", found, "surface:Ci", radiance,
           "primitive:N", normalThere) {
        hits += 1 / (1 + far);
        if (comp(radiance, 0) > 2) break;
    } else {
        missed += .5 + .5 * ycomp(normalize(way));
    }
    gather(what, P + .1 * Nf, R, 0, 1) hits += .1;
    if (rayhittest(P, R, there, bent) < 1e29)
        found += color(bent) * .1;
    hits += occlusion(P, Nf, samples, "coneangle", cone, "maxdist", 4, "environmentdir", way);
    color through = transmission(P, P + 3 * vector Nf, "samples", 2, "samplecone", .1, "bias", .01);
    through += visibility(P, point "world" (0, 3, 0)) + fulltrace(P, R, far, there, bent, there, way);
    if (rayinfo("length", long) == 1 && raydepth() < 3)
        radiance += trace(P, R) / (1 + long);
    Oi = Os;
    Ci = Os * Cs * (missed / samples + through + found * indirectdiffuse(P, Nf, samples)) * (2 - hits)
        + .1 * radiance;
}
