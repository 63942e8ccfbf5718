/* SPDX-License-Identifier: Apache-2.0
   Three random numbers, shining or reflected. */
surface dice(float shining = 1;)
{
    color thrown = color (random(), random(), random());
    Oi = 1;
    Ci = shining > 0 ? thrown : thrown * diffuse(faceforward(normalize(N), I));
}
