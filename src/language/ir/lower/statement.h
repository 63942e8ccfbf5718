// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "language/ir/lower/lowering.h"

namespace candela::ir {

/// Lowers statements; what follows a jump in a list runs only where the jump did not happen.
void lower(Lowering &, const std::vector<sl::StmtPtr> &, size_t first = 0);
void lower(Lowering &, const sl::Stmt &);

} // namespace candela::ir
