/* SPDX-License-Identifier: Apache-2.0
   Asks for light in a loop whose length varies over the surface. */
surface wandering(float turns = 2)
{
    normal facing = faceforward(normalize(N), I);
    color sum = 0;
    float i, length = turns + mod(floor(100 * u), 2);

    Oi = Os;
    for (i = 0; i < length; i = i + 1)
        sum += diffuse(facing);
    Ci = Os * sum / length;
}
