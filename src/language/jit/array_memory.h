// SPDX-License-Identifier: Apache-2.0
// The function's arrays. An index outside is clamped and reported.
#pragma once

#include "language/jit/turn_limit.h"

#include <vector>

namespace candela::codegen {

class ArrayMemory {
public:
    /// Takes memory for all arrays at the function's entry.
    ArrayMemory(CodeFunction &, ValueTable &, RuntimeCalls &, const TurnLimit &);

    /// All elements are zero at the head of a block.
    void clear();
    Value *load(const ir::Instruction &);
    void store(const ir::Instruction &);

private:
    /// For an index that varies: the array's start, and `index` becomes each lane's element. For a
    /// uniform one: the row of all lanes.
    Value *elementAddress(const ir::Instruction &, Value *&index);
    void checkIndex(const ir::Instruction &, Value *raw, Value *clamped);

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    ValueTable &values_;
    RuntimeCalls &calls_;
    const TurnLimit &limit_;
    std::vector<llvm::AllocaInst *> memory_; ///< Of Function::arrays: rows of scalars or of lanes.
};

} // namespace candela::codegen
