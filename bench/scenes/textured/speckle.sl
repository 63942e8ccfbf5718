/* SPDX-License-Identifier: Apache-2.0
   Diffuse, in tones of the surface's colour that change within a pixel or two: fine noise. */
surface speckle(float size = .03; /* of the smallest grains, in shader space */)
{
    point place = transform("shader", P) / size;
    float grains = .5 * (float noise(place) + float noise(place / 3.1));
    color body = Cs * smoothstep(.25, .75, grains) + color (.04, .04, .04);

    Oi = Os;
    Ci = Os * body * diffuse(faceforward(normalize(N), I));
}
