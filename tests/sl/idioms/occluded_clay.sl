/* SPDX-License-Identifier: Apache-2.0 */
/* Clay under an overcast sky. */
surface occluded_clay(float samples = 32, maxdist = 1e10, Kd = .8; string occlmap = "";)
{
    normal n = normalize(N), nf = faceforward(n, I);
    vector bent = 0;
    float occ;
    if (occlmap == "")
        occ = occlusion(P, nf, samples, "maxdist", maxdist, "coneangle", PI / 2, "environmentdir", bent);
    else
        occ = occlusion(occlmap, P, nf, 0);
    Oi = Os;
    Ci = Os * Cs * Kd * (1 - occ);
}
