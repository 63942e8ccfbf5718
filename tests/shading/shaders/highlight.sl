/* SPDX-License-Identifier: Apache-2.0
   specular() alone. */
surface highlight(float roughness = .5;)
{
    Oi = Os;
    Ci = specular(faceforward(normalize(N), I), -normalize(I), roughness);
}
