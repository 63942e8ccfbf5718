// SPDX-License-Identifier: Apache-2.0
// What the builder need not emit.
#pragma once

#include "language/ir/core/builder.h"

#include <optional>

namespace candela::ir {

/// The value that an operation comes to if constants decide it or an identity that holds for
/// every float, -0 and NaN included, does.
std::optional<ValueId> foldOperation(Builder &, Op, const std::vector<ValueId> &operands);

/// Sets Function::inputsRead from the operations that are there: Input, and Random, which reads the
/// seed.
void markInputsRead(Function &);

} // namespace candela::ir
