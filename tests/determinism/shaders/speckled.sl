/* SPDX-License-Identifier: Apache-2.0
   A matte surface with turbulent colour, and loops and branches that lanes take differently. */
surface speckled(float Kd = .5;)
{
    point PP = transform("shader", P);
    float sum = 0, size = 1;
    while (size < 1 + 6 * noise(PP)) {
        sum += abs(noise(PP * size * 2) - .5) / size;
        size *= 2;
    }
    color base = color(.9, .9, .8);
    if (mod(floor(xcomp(PP)) + floor(zcomp(PP)), 2) > .5)
        base = color(.3, .35, .5);
    normal facing = faceforward(normalize(N), I);
    Oi = Os;
    Ci = Os * Cs * mix(base, color(.6, .2, .1), smoothstep(.2, .7, sum)) * Kd * diffuse(facing);
}
