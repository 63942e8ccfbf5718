// SPDX-License-Identifier: Apache-2.0
// Which corner of a triangle comes first. Whoever meets triangles takes their normal from the edges
// at the first corner; the product of two long edges of a needle is rounded by more than the needle
// is wide, and rays then meet the walls of a thin tube out of order.
#pragma once

#include "foundation/base/vec3.h"

#include <algorithm>
#include <array>

namespace candela {

/// The corner to begin at: the first, unless its edges are nearly parallel; then the one opposite
/// the longest edge, where the product is rounded least.
inline int bluntCorner(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 edge[3] = {b - a, c - b, a - c};
    const float squared[3] = {dot(edge[0], edge[0]), dot(edge[1], edge[1]), dot(edge[2], edge[2])};
    const int longest = int(std::max_element(squared, squared + 3) - squared);
    const bool needle =
        squared[0] * squared[2] > 64 * squared[(longest + 1) % 3] * squared[(longest + 2) % 3];
    return needle ? (longest + 2) % 3 : 0;
}

/// The same triangle, turning the same way, begun at that corner.
template <class T> void beginAt(int corner, std::array<T, 3> &triangle) {
    std::rotate(triangle.begin(), triangle.begin() + corner, triangle.end());
}

} // namespace candela
