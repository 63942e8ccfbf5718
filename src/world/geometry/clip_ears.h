// SPDX-License-Identifier: Apache-2.0
// Triangles of a loop in the plane, ear by ear.
#pragma once

#include "world/geometry/flat_polygon.h"

#include <array>
#include <cstdint>
#include <vector>

namespace candela {

/// What is done where no ear is left, as the loop crosses itself: it is given up, with the
/// triangles that there are, or some corner is.
enum class WithoutEars { Stop, Force };

/// Appends the triangles of a loop that turns counter-clockwise, bridges included. False if it
/// crosses itself. Takes about n log n.
bool clipEars(const FlatLoop &, WithoutEars, std::vector<std::array<std::uint32_t, 3>> &triangles);

} // namespace candela
