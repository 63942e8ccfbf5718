// SPDX-License-Identifier: Apache-2.0
// Everything before code generation takes less than 2 s and 500 MB for each of the large shaders,
// by a result or by an error that helps.
#include "large_shaders.h"

#include "workers.h"

#include "language/ir/analyse/control_relevance.h"
#include "language/ir/core/regions.h"
#include "language/ir/lower/lower.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/fold.h"
#include "language/ir/transform/light_rule.h"
#include "language/jit/jit.h"
#include "language/semantics/front.h"

#include <cstdlib>
#include <ctime>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <utility>

namespace candela::budgets {
namespace {

/// What the process that tries a shader tells of it.
struct Figures {
    double front, lower, facts, slices, code; ///< Seconds.
    std::size_t instructions;                 ///< Of the whole text.
    std::size_t largest;                      ///< Of its slices' the most.
    double mebibytes;
};

Figures *sharedFigures() {
    static auto *figures = static_cast<Figures *>(
        mmap(nullptr, sizeof(Figures), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    return figures;
}

class Watch {
public:
    /// Seconds of the processor since the last one.
    double lap() {
        const std::clock_t start = std::exchange(start_, std::clock());
        return double(start_ - start) / CLOCKS_PER_SEC;
    }

private:
    std::clock_t start_ = std::clock();
};

/// What is wrong with a refusal.
std::string judge(const DiagnosticList &diagnostics, const LargeShader &shader) {
    if (shader.outcome == Outcome::Compiles)
        return "is refused\n" + diagnostics.text();
    const Diagnostic first = diagnostics.all().at(0);
    const bool placed = first.where.file && first.where.line > 0 && first.where.column > 0 &&
                        !first.sourceLine.empty();
    if (!placed || first.message.find(shader.says) == std::string::npos)
        return "is refused with a message that does not help\n" + format(first);
    return {};
}

/// Code as well: of some shaders for the question that comes to most; of all, to see what all
/// takes.
bool generates(const LargeShader &shader, ir::Question question) {
    const bool most = question == ir::Question::Prepare || question == ir::Question::Emission;
    return (shader.generates && most) || std::getenv("CANDELA_BUDGETS_CODE") != nullptr;
}

void generate(const ir::Function &function) {
    static DiagnosticList diagnostics;
    static JitOptions options;
    options.useCache = false;
    static Jit jit(options, diagnostics);
    jit.compile(function);
}

std::string compile(const LargeShader &shader, fuzz::Monitor &monitor) {
    Figures &figures = *sharedFigures();
    DiagnosticList diagnostics;
    Watch watch;
    monitor.show(shader.text);
    const auto front = sl::analyzeSource({"large.sl", shader.text}, {}, diagnostics);
    figures.front = watch.lap();
    if (!front)
        return judge(diagnostics, shader);
    monitor.enter(fuzz::Stage::Lower, "");
    auto lowered = ir::lower(*front->shaders[0], {}, {}, diagnostics);
    figures.lower = watch.lap();
    if (!lowered)
        return judge(diagnostics, shader);
    figures.instructions = ir::instructionCount(lowered->whole.body);
    if (lowered->kind == sl::ShaderKind::Light) {
        for (const ir::Question question : {ir::Question::Light, ir::Question::Emission})
            if (generates(shader, question))
                generate(ir::slice(lowered->whole, question));
        figures.code = watch.lap();
        return {};
    }
    monitor.enter(fuzz::Stage::Facts, "");
    std::vector<ir::FoldedValue> values;
    for (const int slot : ir::controlRelevantParameters(lowered->whole))
        values.push_back({slot, 3});
    const ir::Function whole =
        ir::applyLightRule(ir::fold(lowered->whole, values), ir::LightRule::Path);
    const auto plan = ir::makePlan(whole);
    ir::surfaceFacts(*plan);
    figures.facts = watch.lap();
    using enum ir::Question;
    for (const ir::Question question : {Shade, Surface, View, Prepare, Scatter, Emit, Opacity}) {
        monitor.enter(fuzz::Stage::Slice, std::to_string(int(question)));
        const ir::Function slice = ir::slice(*plan, question);
        figures.largest = std::max(figures.largest, ir::instructionCount(slice.body));
        figures.slices += watch.lap();
        monitor.enter(fuzz::Stage::Generate, std::to_string(int(question)));
        if (generates(shader, question))
            generate(slice);
        figures.code += watch.lap();
    }
    return shader.outcome == Outcome::Refused ? "is not refused" : "";
}

class Budgets : public testing::TestWithParam<LargeShader> {};

TEST_P(Budgets, AreKept) {
    const LargeShader &shader = GetParam();
    *sharedFigures() = {};
    const char *scale = std::getenv("CANDELA_TIME_SCALE");
    fuzz::Limits limits;
    limits.seconds *= scale ? std::max(1.0, std::atof(scale)) : 1;
    const fuzz::Failure failure = fuzz::tryAlone(
        [&](std::uint64_t, fuzz::Monitor &monitor) {
            const std::string problem = compile(shader, monitor);
            rusage usage{};
            getrusage(RUSAGE_SELF, &usage);
            sharedFigures()->mebibytes = double(usage.ru_maxrss) / 1024;
            return problem;
        },
        limits, 0);
    EXPECT_EQ(failure.problem, "") << nameOf(failure.stage) << " " << failure.detail;
    const Figures &f = *sharedFigures();
    std::printf("front %.3f lower %.3f facts %.3f slices %.3f code %.3f s, %.0f MiB; %zu "
                "instructions, slices up to %zu\n",
                f.front, f.lower, f.facts, f.slices, f.code, f.mebibytes, f.instructions,
                f.largest);
}

INSTANTIATE_TEST_SUITE_P(All, Budgets, testing::ValuesIn(largeShaders()), [](const auto &info) {
    std::string name;
    for (const char c : info.param.name)
        if (std::isalnum(static_cast<unsigned char>(c)))
            name += c;
        else if (c == ' ')
            name += '_';
    return name;
});

} // namespace
} // namespace candela::budgets
