/* SPDX-License-Identifier: Apache-2.0 */
surface
retro_31 (Ka, Kd, Ks, roughness, specularcolor, stripes)
    float Ka = 1, Kd = .5, Ks = .5;
    float roughness = .1;
    color specularcolor = 1;
    float stripes = 6;
{
    point Nf, V;
    float band;

    Nf = faceforward( normalize(N), I );
    V = -normalize(I);
    band = step(.5, mod(stripes*s, 1));
    Oi = Os;
    Ci = Os * ( mix(Cs, 1-Cs, band) * (Ka*ambient() + Kd*diffuse(Nf)) +
                specularcolor * Ks * specular(Nf,V,roughness) );
}
