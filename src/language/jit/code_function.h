// SPDX-License-Identifier: Apache-2.0
// The LLVM function under construction: what all parts of the generator write to. Private to the
// generator, as all that stands in `codegen`.
#pragma once

#include "language/jit/code_target.h"
#include "language/jit/lanes.h"
#include "language/jit/mask_stack.h"

#include <llvm/IR/Module.h>

#include <functional>
#include <string>
#include <vector>

namespace candela::codegen {

using llvm::Value;
using Values = std::vector<Value *>;

struct CodeFunction {
    /// Adds void symbol(const ShaderArgs *) to the module; the builder stands at its entry.
    CodeFunction(const CodeTarget &, llvm::Module &, const std::string &symbol);

    const CodeTarget &target;
    llvm::Module &module;
    llvm::IRBuilder<> builder;
    Lanes lanes;
    MaskStack masks;
    llvm::Function *function = nullptr;
    int colorSamples = 0;       ///< Of every colour in it.
    bool fusesProducts = false; ///< As ir::Function::isFused.
    llvm::Type *const floatType, *const integerType, *const pointerType;

    /// A machine function beside it, which it calls for a part of its work.
    llvm::Function *addPiece(llvm::ArrayRef<llvm::Type *> arguments);
    llvm::BasicBlock *block(const char *name);
    /// What `body` writes runs if the condition (one bool for all lanes) holds, and gives its
    /// values then; else they are `otherwise`, or zero without. Masks are given in the form that is
    /// kept.
    Values valuesIf(Value *condition, const char *name, const std::function<Values()> &body,
                    const Values &otherwise = {});
    /// Runs what `body` writes `count` times, with 0, 1, ...; `count` > 0.
    void repeat(int count, const char *name, const std::function<void(Value *turn)> &body);
    /// Element `index` of a table of constants.
    Value *constantAt(llvm::Constant *table, Value *index);
    /// Memory for the whole call.
    Value *entryMemory(llvm::Type *, int count, const char *name);
    /// From where nothing changes during a call.
    Value *invariantLoad(llvm::Type *, Value *from);
    /// A function that code may call; a pure one depends on its arguments alone.
    llvm::FunctionCallee external(const std::string &name, llvm::FunctionType *, bool pure);
};

} // namespace candela::codegen
