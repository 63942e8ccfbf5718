/* SPDX-License-Identifier: Apache-2.0
   A deformation: shifts what is farther to the right farther up, in the shader's space. */
transformation bend(float by = .5;)
{
    point p = transform("shader", P);
    p += by * xcomp(p) * vector "shader" (0, 1, 0);
    P = transform("shader", "current", p);
}
