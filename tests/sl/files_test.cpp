// SPDX-License-Identifier: Apache-2.0
// Shader files in the idioms of three decades compile, as far as their kind runs; none has errors.
#include "foundation/base/whole_file.h"
#include "language/ir/lower/lower.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/light_rule.h"
#include "language/semantics/front.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace candela::sl::test {
namespace {

std::vector<std::string> shaderFiles() {
    std::vector<std::string> files;
    for (const char *folder : {"dialects", "idioms"})
        for (const auto &entry : std::filesystem::directory_iterator(
                 CANDELA_SOURCE_DIR "/tests/sl/" + std::string(folder)))
            if (entry.path().extension() == ".sl")
                files.push_back(entry.path().string());
    std::ranges::sort(files);
    return files;
}

class Files : public testing::TestWithParam<std::string> {};

TEST_P(Files, Compile) {
    std::string problem;
    const auto text = readWholeFile(GetParam(), problem, 1 << 20);
    ASSERT_TRUE(text) << problem;
    DiagnosticList diagnostics;
    const auto front = analyzeSource({GetParam(), *text}, {}, diagnostics);
    ASSERT_TRUE(front) << diagnostics.text();
    for (const auto &shader : front->shaders) {
        const auto lowered = ir::lower(*shader, {}, {}, diagnostics);
        ASSERT_TRUE(lowered) << diagnostics.text();
        const ir::Function whole = ir::applyLightRule(lowered->whole, ir::LightRule::Path);
        const auto plan = ir::isPlanned(shader->kind) ? ir::makePlan(whole) : nullptr;
        for (const ir::Question question : ir::questionsOf(shader->kind)) {
            const ir::Function answer =
                plan ? ir::slice(*plan, question) : ir::slice(whole, question);
            EXPECT_EQ(ir::verify(answer), "") << ir::nameOf(question);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Files, testing::ValuesIn(shaderFiles()), [](const auto &info) {
    return std::filesystem::path(info.param).stem().string();
});

} // namespace
} // namespace candela::sl::test
