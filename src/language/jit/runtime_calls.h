// SPDX-License-Identifier: Apache-2.0
// Calls of the renderer's own functions: noise and its like, printf(), indices outside arrays.
#pragma once

#include "language/jit/shader_arguments.h"
#include "language/jit/value_table.h"

#include <map>
#include <string>
#include <vector>

namespace candela::codegen {

class RuntimeCalls {
public:
    RuntimeCalls(CodeFunction &, const ShaderArguments &, ValueTable &);

    /// One of Function::strings as code knows it, an integer; equal texts agree.
    Value *string(int index) const;
    void call(const ir::Instruction &);
    void print(const ir::Instruction &);
    /// That the instruction's index is outside its array.
    void reportIndexOutside(const ir::Instruction &);
    /// That the loop has been ended.
    void reportLoopEnded(const ir::Instruction &);

private:
    Value *text(const std::string &bytes);
    void report(const char *symbol, const ir::Instruction &);

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    const ShaderArguments &arguments_;
    ValueTable &values_;
    std::vector<int> stringOffset_; ///< Of Function::strings, in strings_.
    std::string strings_;
    struct CallMemory {
        Value *inputs = nullptr, *outputs = nullptr;
    };
    std::map<llvm::Function *, CallMemory>
        callMemory_; ///< For a call's values, a machine function.
};

} // namespace candela::codegen
