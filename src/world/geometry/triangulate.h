// SPDX-License-Identifier: Apache-2.0
// Triangles of a polygon with holes, planar or nearly so.
#pragma once

#include "foundation/base/vec3.h"
#include "world/geometry/untangle.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

enum class TriangulationResult {
    Good,
    Degenerate,  ///< No area, or too few corners: nothing was added.
    Approximated ///< A hole lies outside, or the loops cross too often: the rest was triangulated.
};

/// Appends the triangles of one face, as indices into `points`. loops[0] is the outside and gives
/// the orientation: the triangles turn the same way as it, however the holes turn. Collinear and
/// repeated vertices are welcome. The face need not be flat: four corners are cut along the
/// diagonal that folds less, more are cut as they look along an axis from which the loop does not
/// cross itself, or else with the least area. So a face over a convex outline covers all of it,
/// whatever the heights of its corners. Loops that cross themselves or each other cover what is
/// within the outside, but not within holes, an odd number of times; the corners that they make are
/// appended to `made`, and the first of all of these is the number points.size().
TriangulationResult triangulate(std::span<const Vec3> points,
                                std::span<const std::span<const int>> loops,
                                std::vector<std::array<std::uint32_t, 3>> &triangles,
                                std::vector<MadeCorner> &made);

} // namespace candela
