/* SPDX-License-Identifier: Apache-2.0
   Shines, sends light on, and moves its own points, and its normal if it is told to. */
surface selfshining(float share = .7; float by = 0; float turns = 0;)
{
    P += by * normalize(N);
    if (turns == 1)
        N = calculatenormal(P);
    normal facing = faceforward(normalize(N), I);

    Oi = Os;
    Ci = Os * ((1 - share) + share * diffuse(facing));
}
