// SPDX-License-Identifier: Apache-2.0
// Triangles that overlap a little, so that no ray slips between neighbours.
//
// Embree's quick triangle test is exact up to rounding only: about one ray in a million that
// crosses a closed mesh finds no triangle at all, and lets in the sun. Its robust mode is without
// such holes and takes a third more time. Growing each triangle in its plane by the width of the
// holes closes them at no cost for rays; see docs/ray-offset.md.
#pragma once

#include "foundation/base/vec3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace candela {

/// How far edges move outwards, as a share of the mesh's largest coordinate.
inline constexpr float sealShare = 8 * 0x1p-24f;

/// corners[3 t + k] = corner k of triangle t, moved away from the triangle's incentre, in its
/// plane. `corners` holds 3 * triangles.size(). Triangles without area stay as they are.
void sealTriangles(const std::vector<Vec3> &positions,
                   const std::vector<std::array<std::uint32_t, 3>> &triangles, Vec3 *corners);

} // namespace candela
