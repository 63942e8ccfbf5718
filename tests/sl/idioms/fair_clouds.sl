/* SPDX-License-Identifier: Apache-2.0 */
/* Fractal sums with a threshold, over a sky that fades to the horizon. */
float fractalsum(point Q; uniform float octaves, lacunarity, gain)
{
    uniform float amplitude = 1, i;
    varying point pp = Q;
    varying float sum = 0;
    for (i = 0; i < octaves; i += 1) {
        sum += amplitude * (2 * float noise(pp) - 1);
        amplitude *= gain;
        pp *= lacunarity;
    }
    return sum;
}
surface fair_clouds(color skycolor = color(.15, .35, .8), cloudcolor = 1;
                    float txtscale = 2, threshold = .1, sharpness = .4; string shadingspace = "shader";)
{
    point Q = transform(shadingspace, P) * txtscale;
    float cover = smoothstep(threshold, threshold + sharpness, fractalsum(Q, 7, 2.03, .55));
    float horizon = 1 - t;
    Oi = 1;
    Ci = mix(skycolor * (1 + horizon), cloudcolor, cover);
}
