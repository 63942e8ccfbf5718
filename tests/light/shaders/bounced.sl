/* SPDX-License-Identifier: Apache-2.0 */
/* Light from lamps, and what other surfaces send. */
surface bounced(float older = 0;)
{
    normal Nf = faceforward(normalize(N), I);
    color indirect = 0;
    if (older == 1)
        indirect = indirect("", "", P, Nf, I, "microbufres", 8);
    else
        indirect = indirectdiffuse(P, Nf, 64);
    Oi = Os;
    Ci = Cs * (diffuse(Nf) + indirect);
}
