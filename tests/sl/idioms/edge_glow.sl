/* SPDX-License-Identifier: Apache-2.0 */
/* Opaque in the middle, gone at the rim: a ball of gas. */
surface edge_glow(float falloff = 2; output varying color aov_rim = 0;)
{
    float facing = abs(normalize(N) . normalize(I));
    if (facing == 0)
        Oi = 0;
    else
        Oi = Os * pow(facing, falloff);
    aov_rim = 1 - facing;
    Ci = Oi * Cs;
}
