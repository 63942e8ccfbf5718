/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    color c = 0;
    float q = 0;
    string cat = "";
    color k = 0;
    illuminance("-x", P, normalize(N), PI / 2, "light:q", q, "light:__category", cat,
                "send:light:k", k, "lightcache", "reuse")
    {
        c += Cl * q;
    }
    illuminance(P, N, PI / 2, "lightcache", "refresh")
    {
        c += Cl;
    }
    illuminance(P, "light:foo", q)
    {
        c += Cl * q;
    }
    Ci = c;
    Oi = Os;
}
