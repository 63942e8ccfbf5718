// SPDX-License-Identifier: Apache-2.0
// What the triangles that rays meet say of rounding, and of the side that they face.
#pragma once

#include "world/shapes/shape.h"

namespace candela {

/// Rounding of an intersection, against the extent of the element: eight units of a float.
inline constexpr float elementRounding = 8 * 0x1p-24f;

/// The shape's elements against the natural normals, by vote of some triangles: Shape::elementSign.
/// The shape must know how they name points.
float signByVote(const Shape &, const RayShape &);

/// How far along its elements rounding leads astray who meets them.
struct Reach {
    float longestEdge = 0;
    /// The longest edge, and more where the edges at an element's first corner are nearly parallel:
    /// its normal is off by rounding over the sine between them. No more than what lifts one off by
    /// its own width.
    float slender = 0;
};
Reach reachOf(const RayShape &);

} // namespace candela
