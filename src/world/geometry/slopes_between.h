// SPDX-License-Identifier: Apache-2.0
// Derivatives by the shaders' u and v of what is known at points alone: by differences between
// three of them.
#pragma once

#include "world/geometry/surface.h"

namespace candela {

/// Three neighbouring points a lane: where derivatives are wanted, and two beside it that are not
/// on one line with it. Query coordinates.
struct Neighbours {
    SurfaceQuery here, besideA, besideB;
};

/// Derivatives of three planes of values, known at the three points each. Where the points tell
/// nothing (poles) they are 0.
void slopesBetween(const Surface &, const Neighbours &, const Vec3Planes values[3], Vec3Planes byU,
                   Vec3Planes byV);

} // namespace candela
