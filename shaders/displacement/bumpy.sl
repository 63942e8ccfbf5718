/* SPDX-License-Identifier: Apache-2.0
   Moves the surface along its normals by what a picture holds over s and t, black not at all and
   white by amplitude: RI's standard displacement. Without a picture the surface stays as it is. */
displacement bumpy(
    float amplitude = 1;     /* how far white goes, in current space [any, length] */
    string texturename = ""; /* the picture of heights; its first channel counts [a file; "":
                                none] */)
{
    if (texturename != "") {
        P += amplitude * float texture(texturename) * normalize(N);
        N = calculatenormal(P);
    }
}
