// SPDX-License-Identifier: Apache-2.0
// What rays bring that meet nothing: lights at infinity, as far as they are wider than a direction.
#pragma once

#include "light/path/paths.h"
#include "world/scene/lights.h"

#include <vector>

namespace candela {

/// Up to a block of the rays, for one sky after the other.
struct EscapingRays {
    static constexpr int capacity = 512;
    EscapingRays();

    std::vector<int> all; ///< Of the wave's active rays.
    RayOrigins left;
    Planes<float> floats, radiance;
    MutableVec3Planes origin, direction, againstDirection;
    ConstVec3Planes noNormal; ///< 0 in all lanes.
    float *time, *heard, *lightPdf, *weight, *startPosition, *startDirection;
    Planes<std::int32_t> integers;
    std::int32_t *lightSet, *light;
    SkyAnswer answer;
};

} // namespace candela
