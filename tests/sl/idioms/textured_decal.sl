/* SPDX-License-Identifier: Apache-2.0 */
/* A picture where there is one, with its alpha; filters and blur as optional parameters. */
surface textured_decal(float Ka = 1, Kd = .8; string decalname = "", basename = "";
                       float sscale = 1, tscale = 1; color flat = color(.8, .7, .6))
{
    color Ct = flat;
    float ss = s * sscale, tt = t * tscale, a = 0;
    if (basename != "")
        Ct = color texture(basename, ss, tt, "swidth", 1.5, "twidth", 1.5, "filter", "gaussian");
    if (decalname != "") {
        a = float texture(decalname[3], ss, tt, "fill", 0);
        Ct = mix(Ct, color texture(decalname[0], ss, tt, "blur", .01), a);
    }
    Oi = Os;
    Ci = Os * Ct * (Ka * ambient() + Kd * diffuse(faceforward(normalize(N), I)));
}
