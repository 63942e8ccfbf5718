// SPDX-License-Identifier: Apache-2.0
// The sides of patches by their own control points alone.
#pragma once

#include "foundation/base/vec3.h"

#include <array>
#include <vector>

namespace candela {

/// One side of a patch by its own control points alone, so that patches which share a side agree
/// about it to the last bit, whichever way they run along it. Homogeneous Bezier ordinates, rounded
/// to float: those of a Bezier patch are its control points.
struct SideCurve {
    std::vector<std::array<float, 4>> ordinates; ///< Of a degree one less than their number.

    /// The point at step/steps of the way.
    Vec3 at(int step, int steps) const;
};

/// The sides of the patches round a mesh: v = 0, v = 1, u = 0, u = 1.
using MeshSides = std::array<std::vector<SideCurve>, 4>;

} // namespace candela
