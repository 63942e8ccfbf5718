// SPDX-License-Identifier: Apache-2.0
// Carried values that turns only add to, or take the least or the greatest with: the order of the
// turns does not matter.
#pragma once

#include "language/ir/filter/value_facts.h"

#include <optional>

namespace candela::ir {

/// How `next`, what a turn makes of the carried value `before`, is made of it; nothing unless that
/// is all that `before` is used for, and `next` is used but once.
std::optional<Reduction> reductionOf(const ValueFacts &, ValueId before, ValueId next);

} // namespace candela::ir
