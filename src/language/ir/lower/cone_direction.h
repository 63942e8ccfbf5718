// SPDX-License-Identifier: Apache-2.0
// Directions within a cone, by two numbers in [0,1).
#pragma once

#include "language/ir/core/builder_vectors.h"

namespace candela::ir {

/// How likely the directions are, by solid angle.
enum class ConeWeight { Uniform, Cosine };

/// A direction of unit length within `angle` (radians, half of the opening) of the axis; `x` leads
/// from the axis to the rim, `y` around it.
Triple directionInCone(Builder &, const Triple &axis, ValueId angle, ValueId x, ValueId y,
                       ConeWeight);

} // namespace candela::ir
