/* Affine in the light: each light counts as much as it says. */
surface chosen()
{
    illuminance (P, N, PI / 2) {
        float gain = 0;
        lightsource("gain", gain);
        Ci += gain * Cl * normalize(L).normalize(N);
    }
    Oi = 1;
}
