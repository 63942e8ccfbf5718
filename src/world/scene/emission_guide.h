// SPDX-License-Identifier: Apache-2.0
// What pilots have learned of where light paths are worth beginning: from which lights, and from
// point lights in which directions, from distant ones through which part of the disc. Where a
// surface shines from matters as much as whither; of these four numbers too little would be
// learned.
#pragma once

#include "foundation/base/vec3.h"
#include "world/lights/nested_grid.h"

#include <array>
#include <optional>
#include <vector>

namespace candela {

struct EmissionGuide {
    /// Of a light's paths, those that follow the grid; the others begin as they would without.
    double share = 0.8;

    std::vector<std::optional<NestedGrid>> lights; ///< By index; none = nothing is known.
    std::vector<double> probability, cumulative;   ///< Of beginning a path at each.
};

/// Directions on the unit square, equal areas for equal solid angles (an octahedron unfolded, after
/// Clarberg 2008); and back.
std::array<double, 2> squareOfDirection(Vec3 direction);
Vec3 directionOfSquare(double a, double b);

} // namespace candela
