// SPDX-License-Identifier: Apache-2.0
// Calls of the renderer's services (language/runtime/services.h): one for each block of points,
// from all of its lanes that run.
#pragma once

#include "language/jit/constant_strings.h"
#include "language/jit/shader_arguments.h"
#include "language/jit/value_table.h"

#include <map>

namespace candela::codegen {

class ServiceCalls {
public:
    ServiceCalls(CodeFunction &, const ShaderArguments &, ValueTable &, ConstantStrings &);

    /// A Query or a Command, from the lanes that run now; there may be none.
    void ask(const ir::Instruction &);

private:
    /// Where a machine function puts operands and finds results.
    struct Memory {
        Value *operands = nullptr, *results = nullptr;
    };
    const Memory &memory();
    void storeOperands(const ir::Instruction &, ir::Uniformity, Value *to);
    /// A ServiceSite.
    Value *site(const ir::Instruction &);
    llvm::Constant *texts(const ir::ServiceUse &);
    std::string typesOf(const ir::Instruction &) const;

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    const ShaderArguments &arguments_;
    ValueTable &values_;
    ConstantStrings &strings_;
    std::size_t mostOperands_ = 0, mostResults_ = 0; ///< Of any call.
    std::map<llvm::Function *, Memory> memory_;
};

} // namespace candela::codegen
