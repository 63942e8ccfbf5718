/* SPDX-License-Identifier: Apache-2.0 */
/* The share of rays that meet something, of more samples than anybody waits for. */
surface countless(float samples = 1e9)
{
    float hits = 0, misses = 0;

    gather("", P, faceforward(normalize(N), I), PI / 2, samples, "distribution", "cosine")
        hits += 1;
    else
        misses += 1;
    Oi = 1;
    Ci = hits / (hits + misses);
}
