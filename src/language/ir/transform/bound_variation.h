// SPDX-License-Identifier: Apache-2.0
// Which values of a text may differ over a box of surface.
#pragma once

#include "language/ir/core/ir.h"

#include <vector>

namespace candela::ir {

struct BoundVariation {
    std::vector<bool> value; ///< By ValueId.
    std::vector<bool> array; ///< Of its elements.
};
BoundVariation boundVariation(const Function &);
/// May the results differ though no operand does?
bool variesByItself(const Function &, const Instruction &);

} // namespace candela::ir
