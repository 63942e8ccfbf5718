/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    float o =
        occlusion(P, N, 64, "maxdist", 10, "coneangle", PI / 2, "bias", .01, "hitsides", "front",
                  "distribution", "cosine", "falloff", 1, "maxvariation", 0.1, "samplebase", .1);
    color e = 0;
    vector bent = 0;
    o = occlusion(P, N, 32, "environmentmap", "foo.env", "environmentcolor", e, "environmentdir",
                  bent);
    float o2 = occlusion(P, N);
    color d = indirectdiffuse(P, N, 64, "maxdist", 3) + indirectdiffuse("foo.env", N);
    Ci = o + d + o2;
    Oi = Os;
    color tr = transmission(P, P + 10 * N, "samples", 4, "samplecone", .1, "bias", .1);
    Ci *= tr * visibility(P, P + N);
    float h = rayhittest(P, N);
    vector hn = 0;
    point hp = 0;
    h = rayhittest(P, N, hp, hn);
    h = rayhittest(P, P + N);
    Ci *= h;
}
