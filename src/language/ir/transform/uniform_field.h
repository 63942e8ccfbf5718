// SPDX-License-Identifier: Apache-2.0
// The uniform field: radiance 1 from all directions, as light loops are given it where a shader's
// reflectance is wanted (Question::Furnace, Question::Bounds).
//
// A loop whose answer is one whole lobe (diffuse() is) gets its integral. All others are summed
// over `fieldDirections` directions, evenly spaced on the sphere, each of which brings
// Cl = 4 / fieldDirections (docs/contracts.md, 4). The set is turned by Input fieldAxis and stays
// as it is over a box, so that a box's bounds are of one and the same sum.
#pragma once

#include "language/ir/core/builder.h"

namespace candela::ir {

inline constexpr int fieldDirections = 256;

/// What turns the directions: three vectors.
struct FieldFrame {
    Triple x, y, z;
};
FieldFrame fieldFrame(Builder &);
/// Number k, a float from 0 to fieldDirections - 1; of unit length.
Triple fieldDirection(Builder &, const FieldFrame &, ValueId k);

} // namespace candela::ir
