/* SPDX-License-Identifier: Apache-2.0
   Matte about a normal that leans to one side: scattering that is not symmetric. */
surface turned(float Kd = .8; float lean = .5)
{
    normal turnedN = normalize(normalize(N) + lean * normal "world" (0, 1, 0));
    normal Nf = faceforward(turnedN, I);
    Oi = Os;
    Ci = Os * Cs * Kd * diffuse(Nf);
}
