/* SPDX-License-Identifier: Apache-2.0 */
/* What comes from a point five metres before the surface. */
surface through(float samplecone = 0)
{
    vector up = 5 * faceforward(normalize(N), I);

    Oi = 1;
    Ci = transmission(P, P + up, "samples", 64, "samplecone", samplecone);
}
