/* SPDX-License-Identifier: Apache-2.0
   The direction in which light is heard: its cosine with what faces the eye. */
surface toward_distant_light()
{
    normal Nf = faceforward(normalize(N), I);
    Oi = 1;
    Ci = 0;
    illuminance(P, Nf, PI / 2)
        Ci += Cl * (normalize(L) . Nf);
}
