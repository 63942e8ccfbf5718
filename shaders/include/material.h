// SPDX-License-Identifier: Apache-2.0
// Materials as functions, under the names and with the parameters that the shaders of Advanced
// RenderMan use: Nf is the unit normal that faces the eye, basecolor what the surface is painted.
#ifndef MATERIAL_H
#define MATERIAL_H

#include "reflections.h"

color MaterialMatte(normal Nf; color basecolor; float Ka, Kd) {
    return basecolor * (Ka * ambient() + Kd * diffuse(Nf));
}

/// Highlights of the colour of the light over a coat of paint.
color MaterialPlastic(normal Nf; color basecolor; float Ka, Kd, Ks, roughness) {
    extern vector I;
    return MaterialMatte(Nf, basecolor, Ka, Kd) + Ks * specular(Nf, -normalize(I), roughness);
}

/// A sheet through which Kt of the light behind it shines.
color MaterialThinPlastic(normal Nf; vector V; color basecolor; float Ka, Kd, Kt, Ks, roughness) {
    return MaterialMatte(Nf, basecolor, Ka, Kd) + Kt * basecolor * diffuse(-Nf) +
           Ks * specular(Nf, V, roughness);
}

/// Highlights of the colour of the metal.
color MaterialRoughMetal(normal Nf; color basecolor; float Ka, Kd, Ks, roughness) {
    extern vector I;
    return basecolor * (Ka * ambient() + Kd * diffuse(Nf) +
                        Ks * specular(Nf, -normalize(I), roughness));
}

/// The same, and a mirror; without twosided on the side of N alone.
color MaterialShinyMetal(normal Nf; color basecolor; float Ka, Kd, Ks, roughness, Kr, blur;
                         uniform float twosided; DECLARE_ENVPARAMS) {
    extern point P;
    extern normal N;
    extern vector I;
    vector way = normalize(I);
    float mirrors = Kr;
    if (twosided == 0 && N . I > 0)
        mirrors = 0;
    return MaterialRoughMetal(Nf, basecolor, Ka, Kd, Ks, roughness) +
           basecolor * SampleEnvironment(P, reflect(way, Nf), mirrors, blur, ENVPARAMS);
}

color MaterialShinyMetal(normal Nf; color basecolor; float Ka, Kd, Ks, roughness, Kr, blur;
                         DECLARE_ENVPARAMS) {
    return MaterialShinyMetal(Nf, basecolor, Ka, Kd, Ks, roughness, Kr, blur, 1, ENVPARAMS);
}

/// Plastic under a clear coat of index ior, which mirrors by Fresnel's formula.
color MaterialShinyPlastic(normal Nf; color basecolor; float Ka, Kd, Ks, roughness, Kr, blur, ior;
                           uniform float twosided; DECLARE_ENVPARAMS) {
    extern point P;
    extern normal N;
    extern vector I;
    vector way = normalize(I), mirrored, refracted;
    float share, rest;
    fresnel(way, Nf, 1 / ior, share, rest, mirrored, refracted);
    if (twosided == 0 && N . I > 0)
        share = 0;
    return (1 - share) * MaterialMatte(Nf, basecolor, Ka, Kd) +
           Ks * specular(Nf, -way, roughness) +
           SampleEnvironment(P, mirrored, share * Kr, blur, ENVPARAMS);
}

color MaterialShinyPlastic(normal Nf; color basecolor; float Ka, Kd, Ks, roughness, Kr, blur, ior;
                           DECLARE_ENVPARAMS) {
    return MaterialShinyPlastic(Nf, basecolor, Ka, Kd, Ks, roughness, Kr, blur, ior, 1, ENVPARAMS);
}

/// A rough surface that sends light back to where it comes from (Oren and Nayar 1994): roughness is
/// the deviation of its facets' slopes, in radians.
color LocIllumOrenNayar(normal Nf; vector V; float roughness) {
    extern point P;
    float squared = roughness * roughness;
    float A = 1 - 0.5 * squared / (squared + 0.33);
    float B = 0.45 * squared / (squared + 0.09);
    float toEye = acos(clamp(V . Nf, -1, 1));
    vector eyeAcross = normalize(V - Nf * (V . Nf));
    color sum = 0;
    illuminance(P, Nf, PI / 2) {
        vector way = normalize(L);
        float cosine = way . Nf;
        float toLight = acos(clamp(cosine, -1, 1));
        float across = eyeAcross . normalize(way - Nf * cosine);
        sum += Cl * cosine *
               (A + B * max(0, across) * sin(max(toLight, toEye)) * tan(min(toLight, toEye)));
    }
    return sum;
}

color MaterialClay(normal Nf; color basecolor; float Ka, Kd, roughness) {
    extern vector I;
    return basecolor *
           (Ka * ambient() + Kd * LocIllumOrenNayar(Nf, -normalize(I), roughness));
}

/// Highlights with sharp rims: the sharper, the nearer sharpness is to 1.
color LocIllumGlossy(normal Nf; vector V; float roughness, sharpness) {
    extern point P;
    float rim = 0.18 * (1 - sharpness);
    color sum = 0;
    illuminance(P, Nf, PI / 2) {
        vector H = normalize(normalize(L) + V);
        sum += Cl * smoothstep(0.72 - rim, 0.72 + rim, pow(max(0, Nf . H), 1 / roughness));
    }
    return sum;
}

color MaterialCeramic(normal Nf; color basecolor; float Ka, Kd, Ks, roughness, specsharpness) {
    extern vector I;
    return MaterialMatte(Nf, basecolor, Ka, Kd) +
           Ks * LocIllumGlossy(Nf, -normalize(I), roughness, specsharpness);
}

/// Glass of index eta: mirrors, and is seen through by bent rays. rayjitter and raysamples are passed
/// over: paths blur by themselves.
color MaterialGlass(normal Nf; color basecolor; float Ka, Kd, Ks, roughness, Kr, reflblur, Kt,
                    refrblur, eta; color transmitcolor; float rayjitter, raysamples;
                    DECLARE_ENVPARAMS) {
    extern point P;
    extern normal N;
    extern vector I;
    vector way = normalize(I), mirrored, refracted;
    float share, rest, bends = eta;
    if (N . I < 0)
        bends = 1 / eta;
    fresnel(way, Nf, bends, share, rest, mirrored, refracted);
    color through = 0;
    if (Kt * (1 - share) > 0.0001)
        through = Kt * (1 - share) * transmitcolor * trace(P, refracted);
    return MaterialPlastic(Nf, basecolor, Ka, Kd, Ks, roughness) +
           SampleEnvironment(P, mirrored, share * Kr, reflblur, ENVPARAMS) + through;
}

#endif
