/* SPDX-License-Identifier: Apache-2.0
   Highlights alone. */
surface glossy(float roughness = .4;)
{
    normal facing = faceforward(normalize(N), I);
    Oi = Os;
    Ci = Os * Cs * specular(facing, -normalize(I), roughness);
}
