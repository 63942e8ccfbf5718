/* SPDX-License-Identifier: Apache-2.0 */
/* Reflection from an environment map, or rays if the name asks for them. */
surface chrome_map(string envname = ""; string envspace = "world"; float Kr = .8, blur = 0, samples = 8)
{
    normal Nf = normalize(faceforward(N, I));
    vector R = reflect(normalize(I), Nf), Rw = vtransform(envspace, R);
    color ev = 0;
    if (envname == "raytrace")
        ev = trace(P, R);
    else if (envname != "")
        ev = color environment(envname, Rw, "blur", blur, "samples", samples);
    else
        ev = mix(color(.3, .25, .2), color(.6, .75, 1), smoothstep(-.2, .3, ycomp(normalize(Rw))));
    Oi = Os;
    Ci = Os * Cs * Kr * ev;
}
