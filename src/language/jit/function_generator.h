// SPDX-License-Identifier: Apache-2.0
// From ir::Function to one LLVM function, at any width.
#pragma once

#include "language/ir/core/ir.h"
#include "language/jit/code_target.h"

#include <string>

namespace llvm {
class Module;
}

namespace candela {

/// Adds void symbol(const ShaderArgs *) to the module.
void generateFunction(const ir::Function &, const CodeTarget &, const std::string &symbol,
                      llvm::Module &);

} // namespace candela
