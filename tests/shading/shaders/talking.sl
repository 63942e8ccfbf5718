/* SPDX-License-Identifier: Apache-2.0
   Says where it is shaded. With a threshold it is not affine in the light. */
surface talking(float threshold = 0;)
{
    color lit = diffuse(faceforward(normalize(N), I));
    printf("shaded at %p\n", P);
    Oi = Os;
    Ci = lit;
    if (threshold > 0 && comp(lit, 1) > threshold)
        Ci = 1;
}
