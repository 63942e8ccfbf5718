// SPDX-License-Identifier: Apache-2.0
// Calls of the renderer's own functions: noise and its like; reports of mistakes.
#pragma once

#include "language/jit/constant_strings.h"
#include "language/jit/function_pieces.h"
#include "language/jit/shader_arguments.h"
#include "language/jit/value_table.h"

#include <map>
#include <span>
#include <vector>

namespace candela::codegen {

class RuntimeCalls {
public:
    RuntimeCalls(CodeFunction &, const ShaderArguments &, ValueTable &, ConstantStrings &,
                 const FunctionPieces &);

    void call(const ir::Instruction &);
    /// That the instruction's index is outside its array.
    void reportIndexOutside(const ir::Instruction &);
    /// That the loop has been ended.
    void reportLoopEnded(const ir::Instruction &);
    /// Asks whether a filter is to go on.
    Value *goesOn();

private:
    void report(const char *symbol, const ir::Instruction &);
    /// Finds in a region the calls for values of which there are calls with slopes too.
    void pair(const ir::Region &, const FunctionPieces &);
    void pair(std::span<const ir::Instruction>);
    Values evaluate(const ir::Instruction &);
    /// What an instruction calls; its values have the type.
    llvm::FunctionCallee runtimeFunction(const ir::Instruction &, llvm::Type *);

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    const ShaderArguments &arguments_;
    ValueTable &values_;
    ConstantStrings &strings_;
    /// Calls with slopes by calls of the same values alone: one evaluation does, in one region and
    /// one machine function.
    std::map<const ir::Instruction *, const ir::Instruction *> withSlopes_;
    std::map<const ir::Instruction *, Values> evaluated_; ///< What those with slopes gave.
    /// By machine function: memory for what a call gives besides its first value.
    std::map<llvm::Function *, Value *> callMemory_;
};

} // namespace candela::codegen
