// SPDX-License-Identifier: Apache-2.0
// The colours of marble.sl, looked up in registers.
#pragma once

#include "lanes.h"

namespace candela::bench {
namespace {

/// Knots of marble.sl's spline, a row a channel, and what is read past them.
alignas(64) constexpr float knots[3][16] = {
    {.25f, .25f, .20f, .20f, .20f, .25f, .25f, .30f, .35f, .30f, .25f, .20f, .20f},
    {.25f, .25f, .20f, .20f, .20f, .25f, .30f, .35f, .40f, .30f, .30f, .20f, .20f},
    {.35f, .35f, .30f, .30f, .30f, .35f, .45f, .50f, .55f, .50f, .40f, .30f, .30f}};
constexpr int segments = 10;

/// Catmull and Rom's, at x in [0, 1].
Three veins(Floats x) {
    const Floats along = x * float(segments);
    const Floats segment = smaller(floor(along), all(segments - 1));
    const Floats t = along - segment, half = t * .5f;
    const Bits first = wholeBits(segment);
    const Floats weight[4] = {
        half * fused(t, 2.0f - t, all(-1)), fused(half * t, fused(t, all(3), all(-5)), all(1)),
        half * fused(t, fused(t, all(-3), all(4)), all(1)), half * t * (t - 1.0f)};
    Three color;
    for (int c = 0; c < 3; ++c) {
        color[c] = weight[0] * lookUp(knots[c], first);
        for (std::uint32_t k = 1; k < 4; ++k)
            color[c] = fused(weight[k], lookUp(knots[c], first + k), color[c]);
    }
    return color;
}

} // namespace
} // namespace candela::bench
