/* SPDX-License-Identifier: Apache-2.0
   Plastic whose body is painted: the picture, where one is named, multiplies the surface's
   colour. */
surface paintedplastic(
    float Ka = 1;            /* share of ambient light that is sent on [0 to 1] */
    float Kd = .5;           /* albedo of the body, times its colour [0 to 1] */
    float Ks = .5;           /* strength of the highlights [0 to 1] */
    float roughness = .1;    /* their width; the exponent is 8 over it [.001 to 1] */
    color specularcolor = 1; /* their colour, channel by channel [0 to 1] */
    string texturename = ""; /* the picture, over s and t [a file; "": none] */)
{
    normal facing = faceforward(normalize(N), I);
    vector toEye = -normalize(I);
    color paint = Cs;
    if (texturename != "")
        paint *= color texture(texturename);
    color body = Ka * ambient() + Kd * diffuse(facing);
    color coat = specularcolor * Ks * specular(facing, toEye, roughness);

    Oi = Os;
    Ci = Os * (paint * body + coat);
}
