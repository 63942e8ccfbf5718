// SPDX-License-Identifier: Apache-2.0
// Where a long function is cut. LLVM's time grows faster than a function's length, so a long one is
// compiled as several machine functions that call each other; values that are used in another
// function than the one that makes them wait in spill slots.
#pragma once

#include "language/ir/core/ir.h"

#include <cstddef>
#include <map>
#include <vector>

namespace candela {

/// Instructions [begin, end) of a region's body that become a machine function of their own.
struct Piece {
    std::size_t begin = 0, end = 0;
};

struct FunctionPieces {
    /// Of the regions that are cut: their pieces, in order, which cover the body. The instructions
    /// of all other regions belong to the function that their owner belongs to.
    std::map<const ir::Region *, std::vector<Piece>> cut;
    std::vector<int> slot; ///< By ValueId: its spill slot; -1 = it has none.
    int slots = 0;
    /// Where there are many: the function's parameters (Instruction::immediate of Op::Parameter),
    /// which have the first slots, in order.
    std::vector<int> parametersInMemory;

    bool whole() const { return cut.empty(); }
    bool hasSlots() const { return !whole() || !parametersInMemory.empty(); }
};

/// Sources that are loaded once, where a block of points begins: parameters and object matrices.
bool isLoadedAtHead(ir::Op);

/// More parameters than this would all be alive through all of a function, in registers or, one by
/// one, on the stack: they wait in spill slots, and are loaded where they are used.
constexpr std::size_t mostParametersAlive = 64;

/// Cuts the function where few values are alive, so that no piece is much longer than `longest`
/// operations; a function that is no longer stays whole.
FunctionPieces cutIntoPieces(const ir::Function &, int longest);

} // namespace candela
