// SPDX-License-Identifier: Apache-2.0
// Spill slots: where values wait that one machine function makes and another uses, and a function's
// parameters if they are many.
#pragma once

#include "language/jit/code_function.h"
#include "language/jit/function_pieces.h"

#include <utility>

namespace candela::codegen {

class SpillArea {
public:
    /// Takes memory where the builder stands: in the entry.
    SpillArea(CodeFunction &, const FunctionPieces &);

    /// The area as the machine function knows it that is being written.
    Value *base() const { return base_; }
    /// Makes another function's pointer to the area the current one; gives that until now.
    Value *exchangeBase(Value *base) { return std::exchange(base_, base); }

    /// The value, that some function has made, in the function that is being written. Parameters in
    /// memory are not made (null).
    Value *here(ir::ValueId, Value *made);
    /// Where a parameter in memory stands, in rows from base() on; -1 = it is none.
    int rowOfParameter(ir::ValueId id) const {
        return pieces_.slot[id] < int(pieces_.parametersInMemory.size()) ? pieces_.slot[id] : -1;
    }
    /// Saves a value that was made where the builder stands, if others want it.
    void save(ir::ValueId, Value *made);
    /// What could not be saved at once, once all is written.
    void finish();

private:
    struct Loaded {
        llvm::BasicBlock *in = nullptr;
        Value *value = nullptr;
    };
    struct Postponed {
        ir::ValueId id;
        llvm::PHINode *phi;
        Value *base;
    };
    Value *slot(ir::ValueId, Value *base);
    void store(ir::ValueId, Value *made, Value *base);

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    const FunctionPieces &pieces_;
    Value *base_;
    std::vector<Loaded> loaded_; ///< By ValueId: the load in the basic block that asked last.
    std::vector<Postponed> postponed_;
};

} // namespace candela::codegen
