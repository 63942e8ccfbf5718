/* SPDX-License-Identifier: Apache-2.0
   A diffuse body in the surface's colour under a coat with highlights of its own colour. */
surface plastic(float Ka = 1;            /* share of ambient light that is sent on [0 to 1] */
                float Kd = .5;           /* albedo of the body, times its colour [0 to 1] */
                float Ks = .5;           /* strength of the highlights [0 to 1] */
                float roughness = .1;    /* their width; the exponent is 8 over it [.001 to 1] */
                color specularcolor = 1; /* their colour, channel by channel [0 to 1] */)
{
    normal facing = faceforward(normalize(N), I);
    vector toEye = -normalize(I);
    color body = Ka * ambient() + Kd * diffuse(facing);
    color coat = specularcolor * Ks * specular(facing, toEye, roughness);

    Oi = Os;
    Ci = Os * (Cs * body + coat);
}
