/* SPDX-License-Identifier: Apache-2.0 */
/* What of the hemisphere is hidden. */
surface occluded(float samples = 1024; float coneangle = PI / 2; float maxdist = 1e30)
{
    normal facing = faceforward(normalize(N), I);

    Oi = 1;
    Ci = occlusion(P, facing, samples, "coneangle", coneangle, "maxdist", maxdist);
}
