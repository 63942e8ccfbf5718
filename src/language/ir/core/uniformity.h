// SPDX-License-Identifier: Apache-2.0
// Uniform or varying: whatever need not vary is uniform.
#pragma once

#include "language/ir/core/ir.h"

namespace candela::ir {

/// Sets every value's and array's uniformity. A result varies if an operand does or its operation
/// says so; what an If yields also if its condition varies; all carried values of a Loop if its
/// condition does; all results and arguments of a LightLoop; an array if it ever gets a varying
/// value, or at a varying index, or under a varying condition.
void inferUniformity(Function &);

} // namespace candela::ir
