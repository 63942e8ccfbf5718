/* SPDX-License-Identifier: Apache-2.0
   Shines and sends light on. */
surface shining(float share = .7)
{
    Oi = Os;
    Ci = Os * ((1 - share) + share * diffuse(faceforward(normalize(N), I)));
}
