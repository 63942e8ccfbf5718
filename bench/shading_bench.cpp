// SPDX-License-Identifier: Apache-2.0
// Shading speed, points a second: compiled shaders at width 16 and 1 against hand-written C++;
// noise by itself; compile times. codegen_test compares results, here only time counts.
#include "shading_functions.h"

#include "language/ir/interpret/test_batch.h"
#include "language/jit/jit.h"
#include "language/runtime/runtime_functions.h"

#include <benchmark/benchmark.h>

namespace candela::bench {
namespace {

constexpr int points = 1024; // A batch that stays in the first-level cache.

JitOptions optionsAt(int width) {
    JitOptions options;
    options.width = width;
    options.useCache = false;
    return options;
}

void runShader(benchmark::State &state, const ir::Function &function, ShaderFunction code) {
    ir::TestBatch batch(function, points, 1);
    batch.setSamples(4, 1);
    batch.parameterOffset.assign(batch.padded(), 0);
    if (!batch.parameters.empty())
        batch.parameters[0] = 3;
    batch.run(function, [&](const ir::Function &, const ShaderArgs &args) {
        for (auto _ : state)
            code(&args);
    });
    state.SetItemsProcessed(state.iterations() * points);
}

void compiled(benchmark::State &state, ir::Function (*make)(), int width) {
    DiagnosticList diagnostics;
    Jit jit(optionsAt(width), diagnostics);
    const ir::Function function = make();
    const ShaderFunction code = jit.compile(function);
    if (!code)
        return state.SkipWithError(diagnostics.text().c_str());
    runShader(state, function, code);
    const auto statistics = jit.statistics();
    state.counters["optimise_ms"] = statistics.secondsOptimising * 1e3;
    state.counters["emit_ms"] = statistics.secondsEmitting * 1e3;
}

void byHand(benchmark::State &state, ir::Function (*make)(), ShaderFunction code) {
    if (runtime::hostIsaLevel() != runtime::IsaLevel::V4)
        return state.SkipWithError("the hand-written code needs AVX-512");
    runShader(state, make(), code);
}

#define SHADER(name)                                                                               \
    BENCHMARK_CAPTURE(byHand, name, name##Shader, name##ByHand);                                   \
    BENCHMARK_CAPTURE(compiled, name##_w16, name##Shader, 16);                                     \
    BENCHMARK_CAPTURE(compiled, name##_w1, name##Shader, 1);
SHADER(constant)
SHADER(matte)
SHADER(marble)

void noise(benchmark::State &state, runtime::RuntimeFunction function, int width,
           runtime::IsaLevel level) {
    if (level > runtime::hostIsaLevel())
        return state.SkipWithError("this machine lacks the instructions");
    const auto code = runtime::code(function, width, level);
    alignas(64) float inputs[8 * 16], outputs[3 * 16];
    for (int k = 0; k < 8 * 16; ++k)
        inputs[k] = float(k) * 1.37f;
    for (auto _ : state) {
        code(inputs, outputs);
        benchmark::DoNotOptimize(outputs);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * width);
}

using runtime::IsaLevel;
using enum runtime::RuntimeFunction;
BENCHMARK_CAPTURE(noise, noise3_w16_v4, noise3, 16, IsaLevel::V4);
BENCHMARK_CAPTURE(noise, noise3_w16_v3, noise3, 16, IsaLevel::V3);
BENCHMARK_CAPTURE(noise, noise3_w16_v2, noise3, 16, IsaLevel::V2);
BENCHMARK_CAPTURE(noise, noise3_w1_v4, noise3, 1, IsaLevel::V4);
BENCHMARK_CAPTURE(noise, noise4_w16_v4, noise4, 16, IsaLevel::V4);
BENCHMARK_CAPTURE(noise, vnoise3_w16_v4, vnoise3, 16, IsaLevel::V4);
BENCHMARK_CAPTURE(noise, pnoise3_w16_v4, pnoise3, 16, IsaLevel::V4);
BENCHMARK_CAPTURE(noise, cellnoise3_w16_v4, cellnoise3, 16, IsaLevel::V4);

/// A Jit that finds ten shaders in its cache.
void warmStart(benchmark::State &state) {
    DiagnosticList diagnostics;
    JitOptions options;
    std::vector<ir::Function> functions(10, marbleShader());
    for (int k = 0; k < 10; ++k)
        functions[k].strings = {std::to_string(k)}; // Else they were one.
    const auto start = [&] {
        Jit jit(options, diagnostics);
        for (const ir::Function &function : functions)
            benchmark::DoNotOptimize(jit.compile(function));
    };
    start(); // Fills the cache.
    for (auto _ : state)
        start();
}
BENCHMARK(warmStart)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace candela::bench

BENCHMARK_MAIN();
