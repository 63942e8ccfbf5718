/* SPDX-License-Identifier: Apache-2.0 */
/* Only lights of some categories count; messages ask them for their parameters. */
surface lit_by_name(string keys = "key,rim", fills = "-key"; float Kd = .7, Ks = .3, roughness = .1)
{
    normal Nf = faceforward(normalize(N), I);
    vector V = -normalize(I);
    color key = 0, fill = 0, spec = 0;
    float nonspec = 0, gain = 1;
    illuminance(keys, P, Nf, PI / 2, "light:__nonspecular", nonspec, "light:gain", gain) {
        key += Cl * gain * (normalize(L) . Nf);
        if (nonspec < 1)
            spec += (1 - nonspec) * Cl * specularbrdf(normalize(L), Nf, V, roughness);
    }
    illuminance(fills, P, Nf, PI / 2, "lightcache", "refresh")
        fill += Cl * .5 * (1 + normalize(L) . Nf);
    Oi = Os;
    Ci = Os * (Cs * Kd * (key + fill) + Ks * spec);
}
