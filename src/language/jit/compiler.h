// SPDX-License-Identifier: Apache-2.0
// Functions through LLVM, as one module: generate, optimise, emit. Thread-safe: every call has an
// LLVM context of its own.
#pragma once

#include "language/ir/core/ir.h"
#include "language/jit/code_target.h"

#include <optional>
#include <string>
#include <vector>

namespace candela {

/// LLVM's name for a CPU that has what the level has and nothing more.
std::string cpuOfLevel(runtime::IsaLevel);
/// The target of a CPU name (empty = this machine, at the instruction set in force); none if LLVM
/// doesn't know it.
std::optional<CodeTarget> codeTarget(const std::string &cpu, int width);
/// Can this machine execute code for the CPU, within the instruction set in force?
bool hostRunsCode(const std::string &cpu);
/// LLVM's version, for cache keys.
std::string llvmVersion();

enum class EmitForm { Object, Assembly, Ir };

struct CompilerResult {
    std::string bytes; ///< Object file, assembly or IR text.
    std::string error; ///< Empty if all went well.
    double secondsOptimising = 0, secondsEmitting = 0;
};

/// A function and the symbol that its code gets.
struct NamedFunction {
    const ir::Function *function = nullptr;
    std::string symbol;
};

/// Whatever LLVM ends with, even for want of memory, is an error in the result.
CompilerResult compileFunctions(const std::vector<NamedFunction> &, const CodeTarget &, EmitForm);

} // namespace candela
