// SPDX-License-Identifier: Apache-2.0
// How far quantities reach over the footprint of the point that is shaded: what lookups of textures
// average over.
#pragma once

#include "language/ir/lower/lowering.h"

namespace candela::ir {

/// Changes of a quantity along the two axes of the footprint, and from the point to its middle.
struct Extent {
    ValueId x, y, shift;
};

/// By the quantity's slopes; zeros where a shader has no footprint (a light's, a picture's), or
/// where LoweringOptions want none. Nobody is warned of slopes that are not known.
Extent extentOf(Lowering &, ValueId quantity);

} // namespace candela::ir
