// SPDX-License-Identifier: Apache-2.0
// The chain rule, operation by operation.
#pragma once

#include "language/ir/core/builder.h"

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace candela::ir {

/// Derivatives by u and v; nothing = zero.
using Slope = std::array<std::optional<ValueId>, 2>;
using Slopes = std::map<ValueId, Slope>;

/// The operands that the derivative of a plain instruction's results depends on.
std::vector<ValueId> differentiableOperands(const Instruction &);

/// Adds the derivatives of a plain instruction's results, which stands already. What is known of
/// no derivative (random numbers, traced light, runtime lattices of constant cells) has none.
void differentiate(Builder &, const Instruction &, Slopes &);

} // namespace candela::ir
