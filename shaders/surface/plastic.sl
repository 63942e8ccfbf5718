/* SPDX-License-Identifier: Apache-2.0
   A diffuse body in the surface's colour under a coat with highlights of its own colour. */
surface plastic(float Ka = 1;            /* share of ambient light */
                float Kd = .5;           /* albedo of the body */
                float Ks = .5;           /* strength of the highlights */
                float roughness = .1;    /* their width; the exponent is 8 over it */
                color specularcolor = 1; /* their colour */)
{
    normal facing = faceforward(normalize(N), I);
    vector toEye = -normalize(I);
    color body = Ka * ambient() + Kd * diffuse(facing);
    color coat = specularcolor * Ks * specular(facing, toEye, roughness);

    Oi = Os;
    Ci = Os * (Cs * body + coat);
}
