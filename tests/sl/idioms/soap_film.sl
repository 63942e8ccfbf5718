/* SPDX-License-Identifier: Apache-2.0 */
/* Interference by a cosine for each primary; opacity by Fresnel. */
surface soap_film(float thickness = 400, variation = 200, n = 1.33; color wavelength = color(650, 530, 450))
{
    vector V = normalize(I);
    normal Nf = faceforward(normalize(N), V);
    float d = thickness + variation * (float noise(transform("object", P) * 3) - .5);
    float cosIn = -V . Nf, cosT = sqrt(1 - (1 - cosIn * cosIn) / (n * n));
    float path = 4 * PI * n * d * cosT;
    color phase = path / wavelength, film;
    setcomp(film, 0, .5 - .5 * cos(comp(phase, 0)));
    setcomp(film, 1, .5 - .5 * cos(comp(phase, 1)));
    setcomp(film, 2, .5 - .5 * cos(comp(phase, 2)));
    float kr, kt;
    fresnel(V, Nf, 1 / n, kr, kt);
    Oi = kr;
    Ci = film * kr * (specular(Nf, -V, .02) + trace(P, reflect(V, Nf)));
}
