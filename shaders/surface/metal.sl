/* SPDX-License-Identifier: Apache-2.0
   A metal that shows blurred highlights of the lights in its own colour. */
surface metal(float Ka = 1;         /* share of ambient light that is sent on [0 to 1] */
              float Ks = 1;         /* strength of the highlights [0 to 1] */
              float roughness = .1; /* their width; the exponent is 8 over it [.001 to 1] */)
{
    normal facing = faceforward(normalize(N), I);
    vector toEye = -normalize(I);

    Oi = Os;
    Ci = Os * Cs * (Ka * ambient() + Ks * specular(facing, toEye, roughness));
}
