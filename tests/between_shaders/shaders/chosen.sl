/* Affine in the light: each light counts as much as it says. */
surface chosen()
{
    float gain = 0;
    illuminance (P, N, PI / 2) {
        lightsource("gain", gain);
        Ci += gain * Cl * normalize(L).normalize(N);
    }
    Oi = 1;
}
