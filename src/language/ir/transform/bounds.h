// SPDX-License-Identifier: Apache-2.0
// Bounds of what a function gives, over a box of surface about each of its points (docs/bounds.md):
// beside every value that may differ over the box stands its affine form, made by the rule that
// core/ops.def has for the operation.
#pragma once

#include "language/ir/core/ir.h"
#include "language/ir/transform/bound_rules.h"

#include <vector>

namespace candela::ir {

/// What an output's bound is written to.
struct BoundOutputs {
    OutputKind value, byU, byV, tolerance;
};

struct BoundReport {
    /// What is not known, in the order of the text: outputs that it reaches may have no bound.
    std::vector<BoundlessNote> boundless;
    bool isTooLarge = false; ///< With its bounds it would be: they are infinite.
};

/// With its bounds a function has no more instructions than this.
inline constexpr std::size_t mostBoundInstructions = 1 << 15;

/// The function, with the bounds of the outputs in the list. It asks for no light and has no
/// effects.
Function withBounds(const Function &, const std::vector<BoundOutputs> &, BoundReport &);

} // namespace candela::ir
