// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "language/ir/lower/lowering.h"

namespace candela::ir {

Components evaluate(Lowering &, const sl::Expr &);
ValueId evaluateFloat(Lowering &, const sl::Expr &);
/// As a bool: whether the float is not 0.
ValueId condition(Lowering &, const sl::Expr &);

} // namespace candela::ir
