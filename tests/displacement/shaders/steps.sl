/* SPDX-License-Identifier: Apache-2.0
   Blocks that stand out by steps, with walls between. */
displacement steps(float by = .1, freq = 3;)
{
    P += by * cellnoise(freq * transform("object", P)) * normalize(N);
    N = calculatenormal(P);
}
