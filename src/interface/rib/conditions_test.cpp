// SPDX-License-Identifier: Apache-2.0
// Conditional RIB: expressions, branches, what is skipped, and what is wrong with either.
#include "interface/rib/condition.h"
#include "interface/rib/reading_fixture.h"

namespace candela::testing {

namespace {

std::optional<StateValue> named(const std::string &name) {
    if (name == "user:pass")
        return "shadow";
    if (name == "user:x")
        return 2.0;
    if (name == "user:zero")
        return 0.0;
    if (name == "Frame")
        return 17.0;
    return std::nullopt;
}

} // namespace

TEST(Condition, expressionsMeanWhatTheySay) {
    const struct {
        const char *expression;
        bool holds;
    } cases[] = {
        {"1", true},
        {"0", false},
        {"'a'", true},
        {"''", false},
        {"$user:x == 2", true},
        {"$user:x==2.0", true},
        {"$user:x != 2", false},
        {"$user:x < 2", false},
        {"$user:x <= 2", true},
        {"$user:x > 1.5", true},
        {"$user:x >= 2.5", false},
        {"2 == $user:x", true},
        {"$user:pass == 'shadow'", true},
        {"$user:pass == \"beauty\"", false},
        {"$user:pass != 'beauty'", true},
        {"$user:pass < 't'", true},
        {"$user:pass == 2", false}, // A text is no number.
        {"$user:pass > 2", false},
        {"$user:pass", true},
        {"$user:zero", false},
        {"${user:x} == 2", true},
        {"$Frame >= 10 && $Frame < 20", true},
        {"$Frame >= 10 && $Frame < 15", false},
        {"$Frame < 10 || $user:x == 2", true},
        {"!($user:x == 2)", false},
        {"!!$user:x", true},
        {"1 || 0 && 0", true}, // && binds more tightly.
        {"(1 || 0) && 0", false},
        {"1 + 2 * 3 == 7", true},
        {"(1 + 2) * 3 == 9", true},
        {"10 - 4 - 3 == 3", true},
        {"8 / 4 / 2 == 1", true},
        {"-$user:x == -2", true},
        {"1 < 2 == 1", true}, // < binds more tightly than ==.
        {"$user:pass =~ 'had'", true},
        {"$user:pass =~ '^s.*w$'", true},
        {"$user:pass =~ 'beauty|shadow' && 1", true},
        {"$user:pass =~ 'Had'", false},
        {"$user:none =~ '.*'", false},
        {"'17' =~ $Frame", true},
        {"defined(user:x)", true},
        {"defined($user:x)", true},
        {"defined(user:none)", false},
        {"!defined(user:none)", true},
        {"$user:none", false},
        {"$user:none == 'x'", false},
        {"$user:none == $user:none", false}, // What is not set equals nothing.
        {"$user:none != 'x'", true},
        {"$user:none < 1", false},
        {"concat('sha', 'dow') == $user:pass", true},
        {"concat('a', 1, 'b') == 'a1b'", true},
        {"$(concat('user:', 'x')) == 2", true},
        {"\t$user:x\n==\r2 ", true},
    };
    for (const auto &each : cases)
        EXPECT_EQ(conditionHolds(each.expression, named), each.holds) << each.expression;
}

TEST(Condition, whatIsNoExpressionSaysWhy) {
    const std::string deep = std::string(100000, '(') + "1" + std::string(100000, ')');
    for (const std::string &bad : {std::string(""),
                                   std::string("1 +"),
                                   std::string("== 2"),
                                   std::string("$"),
                                   std::string("$1"),
                                   std::string("(1"),
                                   std::string("1)"),
                                   std::string("'open"),
                                   std::string("1 2"),
                                   std::string("word == 'word'"),
                                   std::string("defined x"),
                                   std::string("defined()"),
                                   std::string("concat('a'"),
                                   std::string("1 = 2"),
                                   std::string("\xff"),
                                   std::string("'a' =~ '('"),
                                   std::string("'a' =~ 'a{9}'"),
                                   std::string("'a' =~ '(a)\\1'"),
                                   deep,
                                   std::string(100000, '!')})
        EXPECT_THROW(conditionHolds(bad, named), ConditionError) << bad.substr(0, 40);
}

TEST_F(Reading, oneBranchRuns) {
    const std::string branches = "IfBegin \"$user:x == 1\" Color 1 0 0\n"
                                 "ElseIf \"$user:x == 2\" Color 0 1 0\n"
                                 "ElseIf \"$user:x <= 3\" Color 0 0 1\n"
                                 "Else Color .5 .5 .5 IfEnd Sphere 1 -1 1 360";
    const Color expected[] = {Color(1, 0, 0), Color(0, 1, 0), Color(0, 0, 1), Color(.5f)};
    for (int x = 1; x <= 4; ++x) {
        const std::string value = "[" + std::to_string(x) + "]";
        for (const std::string &how :
             {"Attribute \"user\" \"float x\" " + value, "Attribute \"user\" \"int x\" " + value}) {
            const auto seen = world(how + "\n" + branches);
            EXPECT_EQ(found.text(), "");
            ASSERT_EQ(seen.primitives.size(), 1u);
            EXPECT_EQ(seen.primitives[0].attributes->color, expected[x - 1]) << x;
        }
        read("Option \"user\" \"float x\" " + value + "\nWorldBegin " + branches + "\nWorldEnd");
        EXPECT_EQ(builder.worlds.back().primitives[0].attributes->color, expected[x - 1]) << x;
    }
}

TEST_F(Reading, attributesHideOptionsOfTheirName) {
    const std::string options =
        "Option \"user\" \"string pass\" [\"o\"]\nFrameBegin 3\nWorldBegin\n"
        "Attribute \"user\" \"string pass\" [\"a\"]\n";
    const auto primitivesIf = [&](const std::string &condition) {
        read(options + "IfBegin \"" + condition + "\" Sphere 1 -1 1 360 IfEnd\nWorldEnd FrameEnd");
        EXPECT_EQ(found.text(), "") << condition;
        return builder.worlds.back().primitives.size();
    };
    EXPECT_EQ(primitivesIf("$user:pass == 'a'"), 1u);
    EXPECT_EQ(primitivesIf("$Attribute:user:pass == 'a'"), 1u);
    EXPECT_EQ(primitivesIf("$Option:user:pass == 'o'"), 1u);
    EXPECT_EQ(primitivesIf("$Frame == 3"), 1u);
    EXPECT_EQ(primitivesIf("$Option:user:other == 'o'"), 0u);
}

TEST_F(Reading, conditionsNest) {
    for (int outer : {0, 1})
        for (int inner : {0, 1}) {
            const auto seen = world("IfBegin \"" + std::to_string(outer) + "\"\nIfBegin \"" +
                                    std::to_string(inner) +
                                    "\" Sphere 1 -1 1 360 Else Disk 0 1 360 IfEnd\n"
                                    "Else IfBegin \"1\" Cone 1 1 360 IfEnd IfBegin \"0\" Sphere 1 "
                                    "-1 1 360 IfEnd IfEnd");
            EXPECT_EQ(found.text(), "");
            ASSERT_EQ(seen.primitives.size(), 1u);
            EXPECT_EQ(seen.primitives[0].record->shape.index(),
                      ShapeRecord(outer == 0   ? ShapeRecord(ConeRecord{})
                                  : inner == 1 ? ShapeRecord(SphereRecord{})
                                               : ShapeRecord(DiskRecord{}))
                          .index());
        }
}

// Files for other renderers hide there what only those can read.
TEST_F(Reading, whatIsSkippedIsNotJudged) {
    for (const char *bad :
         {"Spere 1 2 3", "Sphere 1", "\"text\" 3 [4", "WorldEnd", "AttributeEnd", "1.2.3 @@ $",
          "ReadArchive \"missing.rib\"", "ArchiveEnd", "Surface \"unclosed", "\001\002\377",
          "'single' ; ,", "ErrorHandler \"abort\" Foo", "IfBegin \"no expression (\" IfEnd",
          "IfBegin \"(\" Else IfEnd"}) {
        const auto seen = world(std::string("IfBegin \"0\"\nSides 1\n") + bad +
                                "\nElse Sphere 1 -1 1 360\nIfEnd\n"
                                "IfBegin \"1\" Disk 0 1 360 Else Sides 1\n" +
                                bad + "\nIfEnd");
        EXPECT_EQ(found.text(), "") << bad;
        EXPECT_EQ(seen.primitives.size(), 2u) << bad;
        EXPECT_TRUE(seen.ended) << bad;
    }
}

TEST_F(Reading, badConditionsAreReportedAndTheRestIsRead) {
    const struct {
        const char *bad, *message;
        std::size_t spheres;
    } cases[] = {
        {"IfBegin \"1 +\" Sphere 1 -1 1 360 IfEnd", "IfBegin: '1 +': expected a value", 0},
        {"IfBegin \"0\" ElseIf \"(\" Sphere 1 -1 1 360 IfEnd", "ElseIf: '(': expected a value", 0},
        {"IfEnd Sphere 1 -1 1 360", "IfEnd without IfBegin", 1},
        {"Else Sphere 1 -1 1 360", "Else without IfBegin", 1},
        {"ElseIf \"1\" Sphere 1 -1 1 360", "ElseIf without IfBegin", 1},
        {"IfBegin \"0\" Else Else Sphere 1 -1 1 360 IfEnd", "Else after the Else of the IfBegin",
         0},
    };
    for (const auto &each : cases) {
        DiagnosticList list;
        ErrorPolicy policy(list);
        GraphicsState state(builder, shaders, policy, settings);
        RibReader(state, policy)
            .readText(std::string("WorldBegin ") + each.bad + " Disk 0 1 360 WorldEnd", "test.rib");
        EXPECT_EQ(list.count(Severity::Error), 1) << list.text();
        EXPECT_NE(list.text().find(each.message), std::string::npos) << list.text();
        EXPECT_EQ(builder.worlds.back().primitives.size(), each.spheres + 1) << each.bad;
    }
    read("WorldBegin WorldEnd IfBegin \"1\"");
    EXPECT_TRUE(says("test.rib:1:21: error: IfBegin is never closed by IfEnd in this file"));
}

TEST_F(Reading, conditionsHaveALimitOfNesting) {
    std::string deep = "WorldBegin\n";
    for (int i = 0; i < 20000; ++i)
        deep += "IfBegin \"1\"\n";
    deep += "Sphere 1 -1 1 360\n";
    for (int i = 0; i < 20000; ++i)
        deep += "IfEnd\n";
    read(deep + "Disk 0 1 360 WorldEnd");
    EXPECT_EQ(errors(), 1);
    EXPECT_TRUE(says("nested more than 10000 deep"));
    EXPECT_EQ(builder.worlds.back().primitives.size(), 1u);
}

} // namespace candela::testing
