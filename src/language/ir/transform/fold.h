// SPDX-License-Identifier: Apache-2.0
// Folding of instance parameters and of what is constant in loops into a text.
#pragma once

#include "language/ir/core/ir.h"

#include <vector>

namespace candela::ir {

struct FoldedValue {
    int slot;
    float value;
};
/// Replaces Parameter slots by constants where `values[slot]` is given and folds all that follows:
/// constants, branches, loops of known count that are short or hold light requests.
Function fold(const Function &whole, const std::vector<FoldedValue> &values);
/// All parameters, by a block of their values.
Function foldAll(const Function &whole, const std::vector<float> &block);

} // namespace candela::ir
