/* SPDX-License-Identifier: Apache-2.0 */
/* Fresnel, refraction and reflection by trace(), in the manner of ray tracers of 1996. */
surface thin_glass(float Ka = .2, Kd = 0, Ks = .5, Kr = 1, Kt = 1, roughness = .05, eta = 1.5;
                   color transmitcolor = 1; float maxdepth = 5;)
{
    normal Nf = faceforward(normalize(N), I);
    vector In = normalize(I), Rfldir, Rfrdir;
    float kr, kt, e;
    if ((N . I) < 0)
        e = 1 / eta;
    else
        e = eta;
    fresnel(In, Nf, e, kr, kt, Rfldir, Rfrdir);
    kt = 1 - kr;
    color through = 0, mirrored = 0;
    if (raylevel() < maxdepth) {
        mirrored = Kr * kr * trace(P, normalize(Rfldir));
        if (length(Rfrdir) > 0)
            through = transmitcolor * Kt * kt * trace(P, normalize(Rfrdir));
    }
    Oi = 1;
    Ci = Cs * (Ka * ambient() + Kd * diffuse(Nf)) + mirrored + through + Ks * specular(Nf, -In, roughness);
}
