// SPDX-License-Identifier: Apache-2.0
// Leaves out what nothing needs.
#pragma once

#include "language/ir/core/ir.h"

#include <functional>

namespace candela::ir {

/// Removes instructions without effect whose results nobody uses, carried values and results of
/// control flow that nobody reads, stores to arrays that nobody loads from, and loops that only
/// spend time. Renews inputsRead; value numbers stay.
void removeDeadCode(Function &);

/// Leaves out all outputs but those of which the test holds.
void keepOutputs(Function &, const std::function<bool(const OutputName &)> &);

/// Removes all instructions of the operation, which has no results.
void removeAll(Op, Region &);

} // namespace candela::ir
