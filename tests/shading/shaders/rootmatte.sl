/* SPDX-License-Identifier: Apache-2.0
   Matte, by a way that is affine for light that is not negative, which no proof can know. */
surface rootmatte(float Kd = .5; float Kr = 0)
{
    normal facing = faceforward(normalize(N), I);
    color lit = Kd * diffuse(facing);
    color root = color(sqrt(comp(lit, 0) * comp(lit, 0)), sqrt(comp(lit, 1) * comp(lit, 1)),
                       sqrt(comp(lit, 2) * comp(lit, 2)));

    Oi = Os;
    Ci = Os * (root + Kr * trace(P, reflect(I, facing)));
}
