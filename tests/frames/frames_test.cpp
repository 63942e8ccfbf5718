// SPDX-License-Identifier: Apache-2.0
// One surface frame, many views of it, many responses a view: code of every level and width answers
// each of them as the whole text does, of random texts and of all shaders in the tree.
#include "language/ir/interpret/interpreter.h"
#include "language/ir/lower/lower.h"
#include "language/ir/questions/random_text.h"
#include "language/ir/questions/viewed_answers_test_support.h"
#include "language/ir/transform/light_rule.h"
#include "language/jit/jit.h"
#include "language/semantics/front.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace candela {
namespace {

using runtime::IsaLevel;

/// Only levels that both have or lack fused sums round alike.
bool roundsAsHost(IsaLevel level) {
    return (level == IsaLevel::V2) == (runtime::hostIsaLevel() == IsaLevel::V2);
}

struct CodeFor {
    IsaLevel level;
    int width;
};

/// Compiles what it is asked to run, once.
class Compiled {
public:
    explicit Compiled(const CodeFor &code, int longestFunction = 0)
        : jit_(options(code, longestFunction), diagnostics_) {}

    void operator()(const ir::Function &function, const ShaderArgs &args) {
        ShaderFunction &code = known_[ir::print(function)];
        if (!code)
            code = jit_.compile(function);
        ASSERT_TRUE(code) << diagnostics_.text();
        code(&args);
    }

private:
    static JitOptions options(const CodeFor &code, int longestFunction) {
        JitOptions options;
        options.level = code.level;
        options.width = code.width;
        options.longestFunction = longestFunction;
        options.useCache = false;
        return options;
    }
    DiagnosticList diagnostics_;
    Jit jit_;
    std::map<std::string, ShaderFunction> known_;
};

class Frames : public testing::TestWithParam<CodeFor> {
protected:
    void SetUp() override {
        if (!Jit::hostRuns(GetParam().level))
            GTEST_SKIP() << "this machine can't execute code of the level";
    }
    void check(const ir::Function &whole, unsigned seed, const std::vector<float> &parameters = {},
               int longestFunction = 0) {
        Compiled code(GetParam(), longestFunction), oracle({GetParam().level, laneBlock});
        const auto compiled = [&](const auto &...given) { oracle(given...); };
        const auto interpreted = [](const auto &...given) { ir::interpret(given...); };
        ir::ViewedAnswers answers(
            whole, seed, [&](const auto &...given) { code(given...); },
            roundsAsHost(GetParam().level) ? ir::ViewedBatch::Run(interpreted) : compiled);
        if (!parameters.empty())
            answers.points().setParameters(parameters);
        answers.check();
    }
};

TEST_P(Frames, OfRandomTextsServeManyViews) {
    for (unsigned seed = 100; seed < 108 && !HasFailure(); ++seed)
        check(ir::RandomText(seed, seed % 4 == 0, ir::colorSamplesOf(seed)).make(), seed);
}

/// Machine functions that are called for a part of the work look up the same lanes.
TEST_P(Frames, ServePiecesOfFunctions) {
    for (unsigned seed = 200; seed < 203 && !HasFailure(); ++seed)
        check(ir::RandomText(seed, false, 3).make(), seed, {}, 20);
}

std::vector<std::string> shaderFiles() {
    std::vector<std::string> files;
    for (const char *folder : {"shaders", "examples", "tests", "bench"})
        for (const auto &entry : std::filesystem::recursive_directory_iterator(
                 std::filesystem::path(CANDELA_SOURCE_DIR) / folder))
            if (entry.path().extension() == ".sl")
                files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

std::optional<ir::LoweredShader> surfaceIn(const std::string &file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    DiagnosticList diagnostics;
    const auto front = sl::analyzeSource({file, text.str()}, {}, diagnostics);
    if (!front || front->shaders.empty() || front->shaders[0]->kind != sl::ShaderKind::Surface)
        return {};
    return ir::lower(*front->shaders[0], {}, {}, diagnostics); // Some are examples of errors.
}

TEST_P(Frames, OfAllShadersServeManyViews) {
    int surfaces = 0;
    for (const std::string &file : shaderFiles()) {
        const auto lowered = surfaceIn(file);
        if (!lowered)
            continue;
        std::vector<float> parameters(lowered->whole.parameters.size());
        for (const ir::ShaderParameter &parameter : lowered->parameters)
            if (parameter.firstSlot >= 0)
                std::copy(parameter.defaults.begin(), parameter.defaults.end(),
                          parameters.begin() + parameter.firstSlot);
        check(ir::applyLightRule(lowered->whole, ir::LightRule::Path), unsigned(++surfaces),
              parameters);
        if (HasFailure())
            FAIL() << file;
    }
    EXPECT_GT(surfaces, 20);
}

INSTANTIATE_TEST_SUITE_P(Levels, Frames,
                         testing::Values(CodeFor{IsaLevel::V2, 16}, CodeFor{IsaLevel::V2, 1},
                                         CodeFor{IsaLevel::V3, 16}, CodeFor{IsaLevel::V3, 1},
                                         CodeFor{IsaLevel::V4, 16}, CodeFor{IsaLevel::V4, 1}),
                         [](const auto &info) {
                             const CodeFor &code = info.param;
                             return "V" + std::to_string(int(code.level) + 2) + "W" +
                                    std::to_string(code.width);
                         });

} // namespace
} // namespace candela
