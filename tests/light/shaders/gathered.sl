/* SPDX-License-Identifier: Apache-2.0 */
/* The same by hand, and other facts of what rays meet. */
surface gathered(float samples = 256; string what = "hits")
{
    normal facing = faceforward(normalize(N), I);
    float hits = 0, distance = 0;
    color found = 0, radiance = 0, sum = 0;

    gather("illuminance", P, facing, PI / 2, samples, "distribution", "cosine", "ray:length",
           distance, "surface:Cs", found, "surface:Ci", radiance) {
        hits += 1;
        sum += radiance;
    }
    Oi = 1;
    if (what == "hits")
        Ci = hits / samples;
    else if (what == "radiance")
        Ci = sum / samples;
    else if (what == "color")
        Ci = found;
    else
        Ci = rayhittest(P, facing);
}
