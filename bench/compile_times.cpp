// SPDX-License-Identifier: Apache-2.0
// What compiling costs: for every shader of the given files, each entry point by itself with
// nothing in the cache. One line of JSON a shader.
#include "language/ir/lower/lower.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/light_rule.h"
#include "language/jit/jit.h"
#include "language/semantics/front.h"

#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <utility>
#include <vector>

namespace candela::bench {
namespace {

using ir::Question;

/// Seconds of CPU time of this process: others may be busy on the machine.
double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

int instructions(const ir::Region &region) {
    int count = int(region.body.size());
    for (const ir::Instruction &i : region.body)
        for (const ir::Region &inner : i.regions)
            count += instructions(inner);
    return count;
}

double peakMegabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) / 1024;
}

void measureQuestion(const ir::Function &whole, Question question, const JitOptions &options,
                     DiagnosticSink &diagnostics) {
    const double start = now();
    const ir::Function function = ir::slice(whole, question);
    const double sliced = now();
    Jit jit(options, diagnostics);
    const double ready = now();
    jit.compile(function);
    const double end = now();
    const Jit::Statistics statistics = jit.statistics();
    std::printf("{\"name\":\"%s\",\"instructions\":%d,\"sliceMs\":%.2f,\"jitMs\":%.2f,"
                "\"optimiseMs\":%.2f,\"emitMs\":%.2f,\"totalMs\":%.2f}",
                function.name.c_str(), instructions(function.body), 1e3 * (sliced - start),
                1e3 * (ready - sliced), 1e3 * statistics.secondsOptimising,
                1e3 * statistics.secondsEmitting, 1e3 * (end - ready + sliced - start));
    std::fflush(stdout);
}

void measureShader(const sl::TypedShader &shader, const JitOptions &options,
                   DiagnosticSink &diagnostics) {
    const double start = now();
    auto lowered = ir::lower(shader, {}, {}, diagnostics);
    if (!lowered)
        return;
    const double end = now();
    const bool isSurface = lowered->kind == sl::ShaderKind::Surface;
    const ir::Function whole =
        isSurface ? ir::applyLightRule(lowered->whole, ir::LightRule::Path) : lowered->whole;
    const double factsStart = now();
    if (isSurface)
        ir::surfaceFacts(whole);
    std::printf("{\"shader\":\"%s\",\"instructions\":%d,\"lowerMs\":%.2f,\"factsMs\":%.2f,"
                "\"entries\":[",
                shader.name.c_str(), instructions(whole.body), 1e3 * (end - start),
                1e3 * (now() - factsStart));
    using enum Question;
    const char *between = "";
    for (const Question question : isSurface ? std::vector{Shade, Prepare, Scatter, Emit, Opacity}
                                             : std::vector{Light, Emission}) {
        std::printf("%s", std::exchange(between, ","));
        measureQuestion(whole, question, options, diagnostics);
    }
    std::printf("],\"peakMegabytes\":%.0f}\n", peakMegabytes());
}

bool measureFile(const char *path, const JitOptions &options, DiagnosticSink &diagnostics) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    const auto front = sl::analyzeSource({path, text.str()}, {}, diagnostics);
    if (!file || !front)
        return false;
    for (const auto &shader : front->shaders)
        measureShader(*shader, options, diagnostics);
    return true;
}

} // namespace
} // namespace candela::bench

int main(int count, char **words) {
    candela::JitOptions options;
    options.useCache = false;
    candela::DiagnosticList diagnostics;
    bool good = true;
    for (int k = 1; k < count; ++k)
        if (!std::strcmp(words[k], "--cpu") && k + 1 < count)
            options.cpu = words[++k];
        else if (!std::strcmp(words[k], "--longest") && k + 1 < count)
            options.longestFunction = std::atoi(words[++k]);
        else if (!std::strcmp(words[k], "--width") && k + 1 < count)
            options.width = std::atoi(words[++k]);
        else
            good &= candela::bench::measureFile(words[k], options, diagnostics);
    std::fputs(diagnostics.text().c_str(), stderr);
    return good ? 0 : 1;
}
