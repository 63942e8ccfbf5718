/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    bake("foo.bake", s, t, Cs);
    bake("foo.bake", s, t, 1.0);
    bake3d("foo.ptc", "_area,Cs", P, N, "_area", area(P), "Cs", Cs, "interpolate", 1);
    color c = 0;
    float f = texture3d("foo.ptc", P, N, "Cs", c);
    c += photonmap("foo.pm", P, N, "estimator", 50);
    c += caustic(P, N);
    c += subsurface(P, N, "scattering", color(1, 1, 1), "absorption", .1);
    c += subsurface("foo.ptc", P);
    Ci = c + f;
    Oi = Os;
    color al = 0, dl = 0;
}
