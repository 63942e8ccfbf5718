// SPDX-License-Identifier: Apache-2.0
// Large triangles near the eye, cut into small ones, and needles, which get vertices of their own.
//
// A ray's meeting with a triangle is rounded by the triangle's extent: on a ground of 100 km by
// centimetres, everywhere. Cut so that triangles are large only where they are far away, it is
// rounded by the distance from the eye, which nobody sees.
//
// Needles must begin at their blunt corner (corner_order.h), but where a mesh names its points
// directly the order of corners is part of the names.
#pragma once

#include "world/geometry/surface.h"

namespace candela {

/// No triangle's longest edge stays above this many times its distance from the eye.
inline constexpr float longestEdgeShare = 16;

/// Cuts triangles of a mesh that names its points directly (see DicedMesh) and returns the pieces:
/// the triangle that each of the new ones lies in; vertexUv become barycentric coordinates there.
/// Leaves the mesh alone, and returns nothing, where no triangle is large and no needle begins at a
/// corner that is not blunt. `eye` null: nothing is large.
std::vector<std::uint32_t> cutTriangles(DicedMesh &, const Vec3 *eye);

} // namespace candela
