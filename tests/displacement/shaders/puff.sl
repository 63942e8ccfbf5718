/* SPDX-License-Identifier: Apache-2.0
   Blows up by so much. */
displacement puff(float by = .2;)
{
    P += by * normalize(N);
    N = calculatenormal(P);
}
