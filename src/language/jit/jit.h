// SPDX-License-Identifier: Apache-2.0
// IR to native code. LLVM stands behind this door alone.
#pragma once

#include "foundation/base/diagnostics.h"
#include "language/ir/core/ir.h"
#include "language/runtime/isa_level.h"
#include "language/runtime/shader_abi.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace candela {

struct JitOptions {
    int width = laneBlock; ///< 16 or 1; results agree bit by bit.
    std::string cpu;       ///< LLVM's name, for example "znver4"; empty = as `level` says.
    /// Code that all machines of the level can execute; none = this machine's own.
    std::optional<runtime::IsaLevel> level;
    /// Folder of the object cache; empty = $CANDELA_CACHE, else $XDG_CACHE_HOME/candela, else
    /// ~/.cache/candela. A folder that can't be written is done without.
    std::string cacheFolder;
    bool useCache = true;
    int longestFunction = 0; ///< As CodeTarget has it; 0 = as CodeTarget has it by itself.
};

/// Compiles functions and keeps their code alive. Thread-safe.
class Jit {
public:
    Jit(JitOptions, DiagnosticSink &);
    ~Jit();

    /// The function's code, from the cache where it is there; null (and an error that names the
    /// function) if LLVM fails. The code lives as long as the Jit.
    ShaderFunction compile(const ir::Function &);
    /// The same for functions that are compiled together, as one module: null for all of them if
    /// any fails, which this sink is told.
    std::vector<ShaderFunction> compile(std::span<const ir::Function *const>, DiagnosticSink &);

    /// LLVM IR after optimisation, or assembly, as `candela compile --emit llvm|asm` prints it.
    std::string emit(const ir::Function &, bool assembly);

    /// Of the code that is made: whether multiplications and additions may be one
    /// (ir/transform/fuse.h).
    bool fusesProducts() const;

    /// True if this machine can execute code for the given CPU name (empty: always) or level.
    static bool hostRuns(const std::string &cpu);
    static bool hostRuns(runtime::IsaLevel);

    struct Statistics {
        int compiled = 0, fromCache = 0;
        double secondsOptimising = 0, secondsEmitting = 0;
    };
    Statistics statistics() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace candela
