// SPDX-License-Identifier: Apache-2.0
// Triangles of a loop in space, without looking at it along any direction.
#pragma once

#include "foundation/base/vec3.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// Cuts a loop of three or four corners: four along the diagonal that folds them less, the first
/// where neither folds by a right angle. False, and nothing appended, for other loops and where
/// both ways turn a triangle over, so that the loop may cross itself.
bool cutQuickly(std::span<const Vec3> points, std::span<const int> loop,
                std::vector<std::array<std::uint32_t, 3>> &triangles);

/// Appends the triangles of least total area that span the loop. They join all of its corners, so
/// seen from where the loop is convex they cover it. Takes the cube of the number of corners; false
/// for more than 128.
bool spanLoop(std::span<const Vec3> points, std::span<const int> loop,
              std::vector<std::array<std::uint32_t, 3>> &triangles);

} // namespace candela
