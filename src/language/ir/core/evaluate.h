// SPDX-License-Identifier: Apache-2.0
// The one definition of scalar arithmetic, for the interpreter and for folding.
#pragma once

#include "language/ir/core/ir.h"

namespace candela::ir {

/// Next to 1/2. A number below a half stays below 1 if this is added, a half does not.
inline constexpr float belowHalf = 0x1.fffffep-2f;

/// Of operations for which isFloatArithmetic() holds; NaN of others. Those of one operand take `a`.
float evaluateFloat(Op, float a, float b);
/// Of operations for which isFloatComparison() holds.
bool evaluateCompare(Op, float a, float b);
/// Truncated; saturating; NaN gives 0.
int integerFromFloat(float);

} // namespace candela::ir
