// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/diagnostic_limit.h"

#include <gtest/gtest.h>

namespace candela {

namespace {

Diagnostic message(const std::string &text, Severity severity = Severity::Error) {
    return {severity, {}, text, {}, 1};
}

std::string kind(const std::string &text) { return kindOf(message(text)); }

} // namespace

TEST(DiagnosticLimit, KindsDifferByMoreThanNumbersAndNames) {
    const std::pair<const char *, const char *> same[] = {
        {"no vertex 7 of 12", "no vertex 8 of 1200"},
        {"no object 'a' here", "no object 'its sister' here"},
        {"asks for \"P\"", "asks for \"Pw\""},
        {"the widths -1.5e-3 and 2", "the widths .5 and +1e+9"},
        {"shader's line 3: 'x' is 'y'.", "shader's line 14: 'u' is 'v'."},
        {"ends with 3.", "ends with 4."},
    };
    for (auto [a, b] : same)
        EXPECT_EQ(kind(a), kind(b));
    const std::pair<const char *, const char *> different[] = {
        {"Sphere: 1 is wrong", "Torus: 1 is wrong"},
        {"N is wrong", "P is wrong"},
        {"Basis2 is wrong", "Basis3 is wrong"},
        {"shader's space isn't known", "shader's place isn't known"},
        {"ends with 3.", "ends with 3"},
        {"'open", "'shut"},
    };
    for (auto [a, b] : different)
        EXPECT_NE(kind(a), kind(b));
    EXPECT_NE(kindOf(message("a", Severity::Warning)), kindOf(message("a")));
}

TEST(DiagnosticLimit, TellsTwentyOfAKindAndHowManyMore) {
    DiagnosticLimit limit;
    int told = 0;
    for (int i = 0; i < 1000; ++i) {
        told += limit.admits(message("vertex " + std::to_string(i)));
        told += limit.admits(message("index " + std::to_string(i), Severity::Warning));
    }
    for (int i = 0; i < DiagnosticLimit::most; ++i)
        told += limit.admits(message("rare"));
    EXPECT_EQ(told, 3 * DiagnosticLimit::most);
    const std::vector<Diagnostic> rest = limit.rest();
    ASSERT_EQ(rest.size(), 2u);
    EXPECT_EQ(rest[0].message, "980 more like this: vertex 20");
    EXPECT_EQ(rest[1].message, "980 more like this: index 20");
    EXPECT_EQ(rest[0].severity, Severity::Note);
    EXPECT_TRUE(limit.rest().empty());
}

TEST(DiagnosticLimit, EverNewMessagesEndToo) {
    DiagnosticLimit limit;
    std::size_t bytes = 0, told = 0;
    constexpr std::size_t all = 100000;
    for (std::size_t i = 0; i < all; ++i) {
        std::string kindOfItsOwn = "unknown word ";
        for (std::size_t rest = i; rest > 0; rest /= 26)
            kindOfItsOwn += char('a' + rest % 26);
        const Diagnostic next = message(kindOfItsOwn + std::string(1000, ' '));
        if (limit.admits(next))
            ++told, bytes += format(next).size();
    }
    EXPECT_GT(told, 100u);
    EXPECT_LT(bytes, 300000u);
    const std::vector<Diagnostic> rest = limit.rest();
    ASSERT_EQ(rest.size(), 1u);
    EXPECT_EQ(rest[0].message, std::to_string(all - told) + " more messages");
    EXPECT_TRUE(limit.admits(message("something else"))) << "after the end of all";
}

} // namespace candela
