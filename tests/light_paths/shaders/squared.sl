/* SPDX-License-Identifier: Apache-2.0
   Not affine in the light. */
surface squared()
{
    color lit = diffuse(faceforward(normalize(N), I));
    Oi = Os;
    Ci = Os * Cs * lit * lit;
}
