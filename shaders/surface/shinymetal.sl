/* SPDX-License-Identifier: Apache-2.0
   A metal that shows, beside blurred highlights of the lights, what a picture of its surroundings
   holds. */
surface shinymetal(
    float Ka = 1;            /* share of ambient light that is sent on [0 to 1] */
    float Ks = 1;            /* strength of the highlights [0 to 1] */
    float Kr = 1;            /* strength of the surroundings [0 to 1] */
    float roughness = .1;    /* width of the highlights; the exponent is 8 over it [.001 to 1] */
    string texturename = ""; /* the surroundings, z up in world space [a file; "": none] */)
{
    normal facing = faceforward(normalize(N), I);
    vector arriving = normalize(I);
    color light = Ka * ambient() + Ks * specular(facing, -arriving, roughness);
    if (texturename != "")
        light += Kr * color environment(texturename,
                                        vtransform("world", reflect(arriving, facing)));

    Oi = Os;
    Ci = Os * Cs * light;
}
