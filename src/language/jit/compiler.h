// SPDX-License-Identifier: Apache-2.0
// One function through LLVM: generate, optimise, emit. Thread-safe: every call has an LLVM context
// of its own.
#pragma once

#include "language/ir/core/ir.h"
#include "language/jit/code_target.h"

#include <optional>
#include <string>

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

CompilerResult compileFunction(const ir::Function &, const CodeTarget &, const std::string &symbol,
                               EmitForm);

} // namespace candela
