/* SPDX-License-Identifier: Apache-2.0 */
surface a(float samples = 16;)
{
    color c = 0;
    float d = 0;
    vector dir = 0;
    float hits = 0;
    color oo = 0;
    point ph = 0;
    gather("illuminance", P, N, PI / 2, samples, "surface:Ci", c, "ray:length", d, "ray:direction",
           dir, "primitive:P", ph, "distribution", "cosine", "bias", .01, "maxdist", 10,
           "surface:Oi", oo)
    {
        hits += 1;
        Ci += c * d;
    }
    else
    {
        Ci += 1;
    }
    Ci /= samples;
    Oi = Os;
}
