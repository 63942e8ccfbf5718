/* SPDX-License-Identifier: Apache-2.0 */
/* Lights that write what they may not: L and N; a colour wheel by time. */
light gobo_blink(float intensity = 10, rate = 2; point from = point "shader" (0, 2, 0);)
{
    N = normalize(N);
    illuminate(from, N, PI / 3) {
        float phase = mod(time * rate + .5 * atan(ycomp(L), xcomp(L)) / PI, 1);
        Cl = intensity * color "hsv" (phase, 1, 1) / (L . L);
        L = normalize(L);
    }
}
