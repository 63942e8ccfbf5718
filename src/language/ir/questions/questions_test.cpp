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
              (std::vector{Question::Light, Question::Emission}));
}

} // namespace
} // namespace candela::ir
