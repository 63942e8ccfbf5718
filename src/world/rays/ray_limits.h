// SPDX-License-Identifier: Apache-2.0
// What rays do not meet, though it stands there: of shapes that are dissolved those that other
// paths meet, and what lies behind clipping planes.
#pragma once

#include "foundation/base/vec3.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace candela {

/// The number in [0,1) by which a path chooses: it has its time alone that is its own. `share`: how
/// much of the shutter's interval has passed. Where things move it is what is left of the share, so
/// that the choice does not go with the motion.
inline float choiceOf(float share, bool moves) {
    constexpr float below1 = 0x1.fffffep-1f, parts = 4096;
    if (moves)
        share = share * parts - std::floor(share * parts);
    return std::min(share, below1);
}

/// What lies where the normal leads to is cut away.
struct ClippingPlane {
    Vec3 point, normal;

    bool hides(Vec3 P) const { return dot(P - point, normal) > 0; }
};

/// Shortens the ray to what is on the near side of all planes; tMax < tMin where nothing is.
inline void clip(const std::vector<ClippingPlane> &planes, Vec3 origin, Vec3 direction, float &tMin,
                 float &tMax) {
    for (const ClippingPlane &plane : planes) {
        const float height = dot(origin - plane.point, plane.normal);
        const float climb = dot(direction, plane.normal);
        if (climb > 0)
            tMax = std::min(tMax, -height / climb);
        else if (climb < 0)
            tMin = std::max(tMin, height / -climb);
        else if (height > 0)
            tMax = -1;
    }
}

} // namespace candela
