// SPDX-License-Identifier: Apache-2.0
// Maps of filter shaders: runtime/image_access.h says what happens.
#pragma once

#include "language/ir/core/builder.h"

#include <string>

namespace candela::ir {

/// Operands of a lookup, in the order of runtime::LookupOperand.
using LookupOperands = std::array<ValueId, runtime::lookupOperands>;

/// `values` channels (1, or a color's) of the map at a place.
Values imageLoad(Builder &, const std::string &map, int values, runtime::ImageFilter,
                 const LookupOperands &);
/// One value for all channels, or a color.
void imageStore(Builder &, const std::string &map, ValueId x, ValueId y, const Values &);

} // namespace candela::ir
