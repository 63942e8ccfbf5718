// SPDX-License-Identifier: Apache-2.0
// How often a loop runs, if constants decide it.
#pragma once

#include "language/ir/core/ir.h"

#include <map>
#include <optional>

namespace candela::ir {

/// A float, or a bool as 1 or 0.
using Known = float;

/// The number of turns, if what is known decides it and it is at most `most`.
std::optional<int> tripCount(const Instruction &loop, std::map<ValueId, Known> known, int most);

} // namespace candela::ir
