/* SPDX-License-Identifier: Apache-2.0 */
/* Counts the rays that meet something, by hand. */
surface gathered_hits(float samples = 16, angle = PI / 2, maxdist = 10, bias = .001; float falloff = 1)
{
    normal Nf = faceforward(normalize(N), normalize(I));
    float hits = 0, dist = 0;
    vector dir = 0;
    color sky = 0;
    gather("illuminance", P, Nf, angle, samples, "distribution", "cosine", "bias", bias,
           "maxdist", maxdist, "ray:length", dist, "ray:direction", dir) {
        hits += pow(1 - dist / maxdist, falloff);
    } else {
        sky += mix(color(.3, .2, .1), color(.5, .7, 1), .5 + .5 * ycomp(normalize(dir)));
    }
    Oi = Os;
    Ci = Os * Cs * (sky / samples) * (1 - hits / samples);
}
