/* SPDX-License-Identifier: Apache-2.0
   Gives a wall the relief of its bricks; "bricks" paints them. */
#include "bricks.h"

displacement brickrelief(float depth = .02; /* from the mortar to the faces */
                         float width = .24, height = .07, joint = .012;
                         float wear = .6; /* 0 new, 1 old */)
{
    float brick, number;
    float out = relief(s, t, width, height, joint, wear, brick, number);
    P += depth * (out - 1) * normalize(N);
    N = calculatenormal(P);
}
