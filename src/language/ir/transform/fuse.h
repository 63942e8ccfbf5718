// SPDX-License-Identifier: Apache-2.0
// Products that are added to something, rounded once.
#pragma once

#include "language/ir/core/ir.h"

namespace candela::ir {

/// Makes one operation of an addition or subtraction and the product that it alone uses, where both
/// stand in one region. A difference of two products stays two roundings apart: of equal ones it is
/// 0, as in cross products and discriminants it has to be. Goes last, for levels that can do this
/// (Jit::fusesProducts()): no analysis knows what it leaves.
void fuseProducts(Function &);

} // namespace candela::ir
