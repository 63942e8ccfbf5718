// SPDX-License-Identifier: Apache-2.0
// What a function is, for cache keys.
#pragma once

#include "foundation/base/hash.h"
#include "language/ir/core/ir.h"

namespace candela {

/// Adds everything that generated code depends on, floats bit by bit. Names and lines are left out
/// but for the places of array accesses, which the code reports.
void addFunction(ContentHash &, const ir::Function &);

} // namespace candela
