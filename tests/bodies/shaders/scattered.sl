/* SPDX-License-Identifier: Apache-2.0
   A white diffuse surface that is lit by scattered rays alone: a direction of the cosine lobe of
   its own choice, followed as a mirror would. In a closed furnace every ray brings the same. */
surface scattered()
{
    normal facing = faceforward(normalize(N), I);
    vector across = abs(xcomp(facing)) < .7 ? vector "current" (1, 0, 0)
                                            : vector "current" (0, 1, 0);
    vector s = normalize(facing ^ across), t = facing ^ s;
    float share = random(), turn = 2 * PI * random();
    vector direction = sqrt(share) * (cos(turn) * s + sin(turn) * t) + sqrt(1 - share) * facing;

    color incoming = 0;
    illuminance(P, 1, direction, 0, 0, 1)
        incoming += Cl;
    Oi = Os;
    Ci = Os * incoming;
}
