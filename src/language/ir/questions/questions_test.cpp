// SPDX-License-Identifier: Apache-2.0
#include "language/ir/questions/questions.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace candela::ir {
namespace {

TEST(Questions, EachBelongsToOneKindAndHasItsOwnName) {
    std::set<Question> all;
    std::set<std::string> names;
    for (int kind = 0; kind < sl::shaderKindCount; ++kind)
        for (Question question : questionsOf(sl::ShaderKind(kind))) {
            EXPECT_TRUE(all.insert(question).second) << nameOf(question);
            names.insert(nameOf(question));
        }
    EXPECT_EQ(int(all.size()), questionCount);
    EXPECT_EQ(int(names.size()), questionCount);
    EXPECT_EQ(questionsOf(sl::ShaderKind::Light),
              (std::vector{Question::Light, Question::LightBounds, Question::Emission}));
}

TEST(Questions, AreAskedOfEveryKindThatRuns) {
    constexpr int outputs[] = {
#define SHADER_OUTPUT(name) +1
#define SHADER_KIND(name, letter, text, light, runs, outputs) 0 outputs,
#include "language/syntax/kinds.def"
#undef SHADER_KIND
#undef SHADER_OUTPUT
    };
    for (int kind = 0; kind < sl::shaderKindCount; ++kind)
        EXPECT_FALSE(questionsOf(sl::ShaderKind(kind)).empty()) << kind;
    for (int kind = 0; kind < sl::shaderKindCount; ++kind)
        EXPECT_EQ(sl::runsFor(sl::ShaderKind(kind)) == sl::RunsFor::Points, outputs[kind] > 0);
    EXPECT_TRUE(isPlanned(sl::ShaderKind::Surface));
    EXPECT_FALSE(isPlanned(sl::ShaderKind::Light));
}

} // namespace
} // namespace candela::ir
