/* SPDX-License-Identifier: Apache-2.0
   Air that scatters light once: shafts and halos. `scattering` and `absorption` are what a metre
   takes of light, in 1/m; light is scattered by the phase function of Henyey and Greenstein, whose
   `anisotropy` is the mean cosine of the angle, from -1 (back) to 1 (ahead). The light of a ray is
   gathered at `steps` points, which lie as densely as their light counts.

   On its way to these points light is weakened by the volumes that it crosses under the integrator
   "path" alone; under "classic" it arrives as if the air were clear. */
volume haze(
    color scattering = .1; /* what a length of 1 scatters of light [0 up, 1/length] */
    color absorption = 0;  /* what it swallows besides [0 up, 1/length] */
    float anisotropy = 0;  /* mean cosine of the angle by which light is turned [-1, back, to 1,
                              ahead] */
    float steps = 4;       /* points along a ray at which its light is gathered [1 to 64] */)
{
    float far = length(I);
    color extinction = scattering + absorption;
    /* All channels share the points: those of the mean extinction. */
    float mean = (comp(extinction, 0) + comp(extinction, 1) + comp(extinction, 2)) / 3;
    float lost = 1 - exp(-mean * far);
    vector ahead = normalize(I);
    float g = clamp(anisotropy, -.99, .99);

    color gathered = 0;
    float k;
    for (k = 0; k < steps; k += 1) {
        float share = (k + random()) / steps;
        float t = mean > 0 ? -log(1 - share * lost) / mean : share * far;
        /* One over the density of the points there. */
        float stretch = mean > 0 ? lost / (mean * exp(-mean * t)) : far;
        point at = P - I + t * ahead;
        color here = 0;
        illuminance (at) {
            float cosine = normalize(L) . ahead;
            /* 4 PI times the phase function; Cl is radiance over PI. */
            here += Cl / 4 * (1 - g * g) / pow(1 + g * g - 2 * g * cosine, 1.5);
        }
        color clear = color(exp(-comp(extinction, 0) * t), exp(-comp(extinction, 1) * t),
                            exp(-comp(extinction, 2) * t));
        gathered += scattering * here * clear * stretch / steps;
    }
    color through = color(exp(-comp(extinction, 0) * far), exp(-comp(extinction, 1) * far),
                          exp(-comp(extinction, 2) * far));
    Ci = Ci * through + gathered;
    Oi = 1 - (1 - Oi) * through;
}
