// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "language/ir/lower/lowering.h"

namespace candela::ir {

/// A call of one of the text's own functions, which are inlined.
Components call(Lowering &, const sl::Expr &);

} // namespace candela::ir
