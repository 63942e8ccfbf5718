/* SPDX-License-Identifier: Apache-2.0
   A metal that shows blurred highlights of the lights in its own colour. */
surface metal(float Ka = 1;         /* share of ambient light */
              float Ks = 1;         /* strength of the highlights */
              float roughness = .1; /* their width; the exponent is 8 over it */)
{
    normal facing = faceforward(normalize(N), I);
    vector toEye = -normalize(I);

    Oi = Os;
    Ci = Os * Cs * (Ka * ambient() + Ks * specular(facing, toEye, roughness));
}
