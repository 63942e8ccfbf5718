// SPDX-License-Identifier: Apache-2.0
// What is zero whatever the inputs (as long as they are finite).
#pragma once

#include "language/ir/core/ir.h"

namespace candela::ir {

/// By ValueId: the float is provably zero. 0 x counts as zero, as physics has it: an infinite or
/// undefined x is the shader's fault.
std::vector<bool> provablyZero(const Function &);

} // namespace candela::ir
