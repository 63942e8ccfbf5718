// SPDX-License-Identifier: Apache-2.0
// The function's arrays. An index outside is clamped and reported.
#pragma once

#include "language/jit/turn_limit.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace candela::codegen {

class ArrayMemory {
public:
    /// Takes memory for all arrays at the function's entry; captured ones have it.
    ArrayMemory(CodeFunction &, ValueTable &, RuntimeCalls &, const TurnLimit &, ShaderArguments &);

    /// Where the arrays are, as the machine function knows it that is being written.
    const Values &memory() const { return memory_; }
    /// Makes another function's pointers to them the current ones; gives those until now.
    Values exchangeMemory(Values memory) { return std::exchange(memory_, std::move(memory)); }

    /// All elements are zero at the head of a block.
    void clear();
    Value *load(const ir::Instruction &);
    void store(const ir::Instruction &);
    /// Many stores to one array in a row, at known places, of constants or of parameters in memory:
    /// a loop over a table. Of how many of the instructions it has become one; 0 = of none.
    std::size_t storeKnown(std::span<const ir::Instruction>);

private:
    struct KnownStores {
        std::vector<std::uint32_t> to, rows; ///< Elements; rows of parameters.
        std::vector<float> numbers;          ///< Constants.
        std::size_t instructions = 0;
    };
    KnownStores knownStores(std::span<const ir::Instruction>) const;

    /// An array's elements are rows: a scalar, or one a lane.
    llvm::Type *rowOf(const ir::Array &) const;
    /// For an index that varies: the array's start, and `index` becomes each lane's element. For a
    /// uniform one: the row of all lanes.
    Value *elementAddress(const ir::Instruction &, Value *&index);
    /// A whole row, in the active lanes.
    void storeRow(Value *, Value *to);
    void checkIndex(const ir::Instruction &, Value *raw, Value *clamped);

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    ValueTable &values_;
    RuntimeCalls &calls_;
    const TurnLimit &limit_;
    Values memory_; ///< Of Function::arrays.
};

} // namespace candela::codegen
