/* SPDX-License-Identifier: Apache-2.0
   Smooth clear glass: a body whose surface reflects and refracts by Fresnel's equations for
   unpolarised light. Normals point out of the body. Radiance is carried through unscaled (the
   factor eta^2 of the way in is undone on the way out). */
surface glass(
    float eta = 1.5; /* refractive index of the body, against what is around it [.3 to 4] */
    float Kr = 1;    /* share of the reflected light that is kept [0 to 1] */
    float Kt = 1;    /* share of the refracted light that is kept [0 to 1] */)
{
    normal unit = normalize(N);
    vector incoming = normalize(I);
    normal facing = faceforward(unit, incoming);
    float entering = 1;
    if (unit . incoming > 0)
        entering = 0;
    float ratio = mix(eta, 1 / eta, entering);

    float mirrorShare, bentShare;
    vector mirrored, bent;
    fresnel(incoming, facing, ratio, mirrorShare, bentShare, mirrored, bent);
    bentShare = 1 - mirrorShare;

    color reflected = 0, refracted = 0;
    illuminance(P, 1, mirrored, 0, 0, Kr * mirrorShare)
        reflected += Kr * mirrorShare * Cl;
    illuminance(P, 1, bent, 0, 0, Kt * bentShare)
        refracted += Kt * bentShare * Cl;
    Oi = Os;
    Ci = Os * Cs * (reflected + refracted);
}
