// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/regular_expression.h"

#include <gtest/gtest.h>

namespace candela::ir {
namespace {

bool found(const std::string &pattern, const std::string &subject) {
    const auto expression = RegularExpression::parse(pattern);
    EXPECT_TRUE(expression) << pattern;
    return expression && expression->foundIn(subject);
}

struct Case {
    const char *pattern;
    const char *matches;
    const char *differs;
};

TEST(RegularExpression, Finds) {
    const Case table[] = {
        {"b", "abc", "ac"},
        {"^b", "bc", "abc"},
        {"c$", "abc", "cb"},
        {"^a.*c$", "abbc", "abcd"},
        {"a|bc|d", "xbc", "xbx"},
        {"^(ab)+$", "abab", "aba"},
        {"^a?b$", "b", "aab"},
        {"^a{2,3}$", "aaa", "aaaa"},
        {"^a{2}$", "aa", "a"},
        {"^a{2,}$", "aaaaa", "a"},
        {"^[a-c]+$", "abc", "abd"},
        {"^[^a-c]$", "d", "a"},
        {"^[]a-]+$", "a]-", "b"},
        {"^[[:digit:]_]+$", "4_2", "4x"},
        {"\\.tif$", "a.tif", "atif"},
        {"^(a|)b$", "b", "cb"},
        {"^(a*)*$", "aaa", "b"},
        {"^(|a)+b", "aab", "c"},
        {"x}", "x}", "x"},
        {"^a\\\\b", "a\\b", "ab"},
        {"(^a|b)c", "ac", "aac"},
        {"[\\]", "\\", "a"},
    };
    for (const auto &[pattern, matches, differs] : table) {
        EXPECT_TRUE(found(pattern, matches)) << pattern << " in " << matches;
        EXPECT_FALSE(found(pattern, differs)) << pattern << " in " << differs;
    }
    EXPECT_TRUE(found("", ""));
    EXPECT_TRUE(found("^$", ""));
}

TEST(RegularExpression, RefusesWhatIsMalformed) {
    for (const char *pattern :
         {"(",   ")",   "a)",  "[",  "[]",   "[b-a]",  "[[:none:]]", "[[.a.]]",
          "*a",  "a|*", "a**", "a{", "a{x}", "a{2,1}", "a{256}",     "a{99999999999}",
          "{1}", "\\",  "(a",  "a{1"})
        EXPECT_FALSE(RegularExpression::parse(pattern)) << pattern;
}

// Each of these costs a matcher that tries paths one by one exponential time or its stack.
TEST(RegularExpression, TimeAndStackAreBounded) {
    EXPECT_FALSE(found("(a*)*b", std::string(120'000, 'a')));
    EXPECT_FALSE(found("(a|aa)+$", std::string(120'000, 'a') + "b"));
    EXPECT_TRUE(found("(x+x+)+y", std::string(10'000, 'x') + "y"));
    EXPECT_TRUE(found(".*", std::string(120'000, 'a')));
    std::string longest;
    for (int i = 0; i < 1000; ++i)
        longest += "a?";
    EXPECT_TRUE(found(longest + std::string(1000, 'a'), std::string(1000, 'a')));
}

TEST(RegularExpression, SizeIsBounded) {
    EXPECT_FALSE(RegularExpression::parse(std::string(100'000, '(')));
    EXPECT_FALSE(RegularExpression::parse("(((a{200}){200}){200}){200}"));
    EXPECT_FALSE(RegularExpression::parse("(((((){200}){200}){200}){200}){200}"));
    EXPECT_FALSE(RegularExpression::parse(std::string(100'000, 'a')));
    EXPECT_FALSE(RegularExpression::parse(std::string(100'000, '|')));
}

} // namespace
} // namespace candela::ir
