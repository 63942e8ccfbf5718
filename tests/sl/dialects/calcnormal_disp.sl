/* SPDX-License-Identifier: Apache-2.0 */
displacement a(float Km = .1; string space = "shader"; float freq = 2;)
{
    point PP = transform(space, P);
    float mag = noise(freq * PP) - .5;
    vector NN = normalize(N);
    P += Km * mag * NN / length(vtransform(space, NN));
    N = calculatenormal(P);
}
