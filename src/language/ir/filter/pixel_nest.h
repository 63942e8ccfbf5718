// SPDX-License-Identifier: Apache-2.0
// A loop over pixels, or two within each other, and the proof that its turns may run at once.
#pragma once

#include "language/ir/filter/counted_loop.h"

#include <vector>

namespace candela::ir {

/// A sum (or least, or greatest) over all turns.
struct NestReduction {
    Reduction kind;
    ValueId begin;  ///< What it is before the first turn.
    ValueId before; ///< The innermost loop's carried value.
    ValueId next;   ///< What a turn makes of it.
    ValueId result; ///< What it is behind the loops.
};

struct PixelNest {
    CountedLoop columns;                ///< The loop whose turns become lanes.
    std::optional<CountedLoop> rows;    ///< The other one, if there are two.
    const Instruction *outer = nullptr; ///< What both stand in, or the one.
    const Instruction *inner = nullptr;
    std::vector<NestReduction> reductions;
    std::vector<int> mapsRead, mapsReadAround, mapsSet, mapsCovered; ///< As PixelLoop has them.
    std::vector<int> arrays; ///< That it reads and others set.

    /// What stands in the outer loop beside the inner one, and must be computed for it.
    std::vector<const Instruction *> before() const;
    bool isNested() const { return inner != outer; }
};

/// The loop as a nest, if its turns do not see each other.
std::optional<PixelNest> pixelNest(const Function &, const ValueFacts &, const Instruction &loop);

} // namespace candela::ir
