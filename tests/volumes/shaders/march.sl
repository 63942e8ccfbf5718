// SPDX-License-Identifier: Apache-2.0
/* Light that is scattered once, evenly to all sides, at points in the middle of equal steps. */
volume march(float scattering = 1, absorption = 0, steps = 64;)
{
    float far = length(I), size = far / steps, extinction = scattering + absorption;
    color gathered = 0;
    float k;
    for (k = 0; k < steps; k += 1) {
        float t = (k + .5) * size;
        color here = 0;
        illuminance (P - I + t * normalize(I)) here += Cl / 4;
        gathered += scattering * exp(-extinction * t) * size * here;
    }
    Ci = Ci * exp(-extinction * far) + gathered;
    Oi = 1 - (1 - Oi) * exp(-extinction * far);
}
