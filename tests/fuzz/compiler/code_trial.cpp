// SPDX-License-Identifier: Apache-2.0
#include "code_trial.h"

#include "language/ir/transform/fuse.h"
#include "language/jit/jit.h"

namespace candela::fuzz {

namespace {

JitOptions widthOf(int width) {
    JitOptions options;
    options.width = width;
    options.useCache = false;
    return options;
}

/// The generators of a process, which starts without them.
struct Generators {
    DiagnosticList diagnostics;
    Jit wide{widthOf(laneBlock), diagnostics}, narrow{widthOf(1), diagnostics};
};

/// Below that level transcendental functions are not those of the host.
bool interpreterAgrees() {
    static const bool agrees = Jit::hostRuns(runtime::IsaLevel::V3);
    return agrees;
}

} // namespace

std::string compareCode(ir::Function function, Batch &batch, const std::string &question,
                        Monitor &monitor) {
    static Generators generators;
    if (generators.wide.fusesProducts())
        ir::fuseProducts(function);
    const auto frames = batch.frames();
    const auto run = [&](const Batch::Code &code) {
        batch.frames() = frames;
        return batch.run(function, code, Light::Given);
    };
    const auto execute = [&](ShaderFunction code) {
        return run([code](const ir::Function &, const ShaderArgs &args) { code(&args); });
    };
    monitor.enter(Stage::Interpret, question);
    const RunResult expected = run(ir::interpret);
    monitor.enter(Stage::Generate, question + ", W = 16");
    const ShaderFunction wide = generators.wide.compile(function);
    monitor.enter(Stage::Generate, question + ", W = 1");
    const ShaderFunction narrow = generators.narrow.compile(function);
    if (!wide || !narrow)
        return "has no code\n" + generators.diagnostics.text();
    monitor.enter(Stage::Execute, question + ", W = 16");
    const RunResult fromWide = execute(wide);
    monitor.enter(Stage::Execute, question + ", W = 1");
    const RunResult fromNarrow = execute(narrow);
    ++monitor.tally().compared;
    std::string difference = differenceOf(fromWide, fromNarrow);
    if (!difference.empty())
        return "code differs between widths\n" + difference;
    if (interpreterAgrees())
        difference = differenceOf(expected, fromWide);
    return difference.empty() ? "" : "code differs from the interpreter\n" + difference;
}

} // namespace candela::fuzz
