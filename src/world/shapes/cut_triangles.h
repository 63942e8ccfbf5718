// SPDX-License-Identifier: Apache-2.0
// Large triangles near the eye, cut into small ones.
//
// A ray's meeting with a triangle is rounded by the triangle's extent: on a ground of 100 km by
// centimetres, everywhere. Cut so that triangles are large only where they are far away, it is
// rounded by the distance from the eye, which nobody sees.
#pragma once

#include "world/geometry/surface.h"

namespace candela {

/// No triangle's longest edge stays above this many times its distance from the eye.
inline constexpr float longestEdgeShare = 16;

/// Cuts triangles of a mesh that names its points directly (see DicedMesh) and returns the pieces:
/// the triangle that each of the new ones lies in; vertexUv become barycentric coordinates there.
/// Leaves the mesh alone, and returns nothing, where no triangle is large.
std::vector<std::uint32_t> cutLargeTriangles(DicedMesh &, Vec3 eye);

} // namespace candela
