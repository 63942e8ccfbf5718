// SPDX-License-Identifier: Apache-2.0
// Control flow: branches merge cells, loops carry them, jumps become flags.
#pragma once

#include "language/ir/lower/lowering.h"

#include <functional>
#include <vector>

namespace candela::ir {

/// Opens a frame for the shader (null) or a function, with cells for its flag and its result.
void enter(Lowering &, const sl::Function *);

/// Lowers both sides and merges the cells. `clear` names flags that are known to be false if the
/// condition holds.
void branch(Lowering &, ValueId condition, const std::function<void()> &then,
            const std::function<void()> &otherwise, const std::vector<int> &clear = {});

/// All flags that may keep the text from going on.
std::vector<int> liveFlags(Lowering &);
/// Runs it where no break, continue or return has happened.
void whereLive(Lowering &, const std::function<void()> &);

/// What a loop hands from turn to turn.
struct CarriedCells {
    std::vector<int> variables; ///< What its text assigns.
    std::vector<int> results;   ///< Of the function that it may return from.
    std::vector<int> flags;     ///< Of jumps to places outside of it.
    bool breaks = false;        ///< Whether it may break itself.
    bool drawsAnew = false;     ///< See LoopEffects.
};
/// Of a Loop or light statement.
CarriedCells carriedCells(const Lowering &, const sl::Stmt &);

void lowerLoop(Lowering &, const sl::Stmt &);

} // namespace candela::ir
