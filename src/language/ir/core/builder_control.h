// SPDX-License-Identifier: Apache-2.0
// Structured control flow. Callbacks build the regions and return what they yield; a call gives the
// results.
#pragma once

#include "language/ir/core/builder.h"

namespace candela::ir {

/// A constant condition builds only its branch.
Values ifElse(Builder &, ValueId condition, const std::function<Values()> &then,
              const std::function<Values()> &otherwise);
void ifThen(Builder &, ValueId condition, const std::function<void()> &then);
/// While carried[0] (a bool) holds. The callback gets the carried values, returns the next.
Values loop(Builder &, const Values &initial, const std::function<Values(const Values &)> &body);

} // namespace candela::ir
