// SPDX-License-Identifier: Apache-2.0
// Axis-aligned boxes.
#pragma once

#include "foundation/base/vec3.h"

#include <algorithm>
#include <limits>

namespace candela {

struct Box3 {
    Vec3 low{infinity, infinity, infinity};
    Vec3 high{-infinity, -infinity, -infinity};

    static constexpr float infinity = std::numeric_limits<float>::infinity();

    bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
    Vec3 centre() const { return (low + high) * 0.5f; }
    Vec3 extent() const { return high - low; }
    void add(Vec3 p) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
    void add(const Box3 &other) {
        if (!other.empty()) {
            add(other.low);
            add(other.high);
        }
    }
};

} // namespace candela
