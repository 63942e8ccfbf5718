// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/lexer.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <vector>

namespace candela {

struct Lexed {
    std::vector<RibToken> tokens; ///< Without the End.
    DiagnosticList found;

    explicit Lexed(const std::string &text) {
        Lexer lexer(ByteSource::fromMemory(text), "test.rib", found);
        RibToken token;
        for (lexer.next(token); token.kind != TokenKind::End; lexer.next(token))
            tokens.push_back(token);
    }
    /// The tokens as text: R(name) N(number) S(string) [ ].
    std::string text() const {
        std::string result;
        for (const RibToken &token : tokens)
            switch (token.kind) {
            case TokenKind::Request: result += "R(" + token.text + ")"; break;
            case TokenKind::Number: result += token.whole ? "I" : "N"; break;
            case TokenKind::String: result += "S(" + token.text + ")"; break;
            case TokenKind::ArrayBegin: result += "["; break;
            case TokenKind::ArrayEnd: result += "]"; break;
            case TokenKind::End: break;
            }
        return result;
    }
};

TEST(Lexer, byteOrderMarkIsPassed) {
    Lexed lexed("\xEF\xBB\xBF##RenderMan RIB\nSphere 1");
    EXPECT_EQ(lexed.text(), "R(Sphere)I");
    EXPECT_EQ(lexed.found.text(), "");
    EXPECT_EQ(Lexed("Sphere \xEF\xBB\xBF 1").found.count(Severity::Error), 1);
}

TEST(Lexer, tokensOfAllKinds) {
    struct {
        const char *text, *expected;
    } cases[] = {
        {"", ""},
        {"  \t\r\n\f ", ""},
        {"Sphere 1 -1. 1 360", "R(Sphere)INII"},
        {"Color[1 0 .5]", "R(Color)[IIN]"},
        {"\"P\"[0]\"s\"1", "S(P)[I]S(s)I"},
        {"WorldEnd", "R(WorldEnd)"},
        {"# comment Sphere\nDisk", "R(Disk)"},
        {"##RenderMan RIB-Structure 1.0\n", ""},
        {"[1 # in an array ]\n 2]", "[II]"},
        {"1#comment\n2", "II"},
        {"# mac\rDisk\rCone # end\r", "R(Disk)R(Cone)"},
        {"# dos\r\nDisk\r\n", "R(Disk)"},
        {"# caf\xe9\nDisk \"caf\xe9\"", "R(Disk)S(caf\xe9)"},
        {"#", ""},
        {"\"\"", "S()"},
    };
    for (const auto &each : cases) {
        Lexed lexed(each.text);
        EXPECT_EQ(lexed.text(), each.expected) << each.text;
        EXPECT_EQ(lexed.found.text(), "") << each.text;
    }
}

TEST(Lexer, numbersInAllSpellings) {
    struct {
        const char *text;
        double value;
        bool whole;
    } cases[] = {
        {"1", 1, true},
        {"-12", -12, true},
        {"+5", 5, true},
        {"007", 7, true},
        {".5", .5, false},
        {"-.5", -.5, false},
        {"+.5", .5, false},
        {"1.", 1, false},
        {"1e-3", 1e-3, false},
        {"1E+3", 1e3, false},
        {"-2.5e2", -250, false},
        {"16777217", 16777217, true},
        {"1e999", INFINITY, false},
        {"-1e999", -INFINITY, false},
        {"1e-999", 0, false},
        {"inf", INFINITY, false},
        {"-inf", -INFINITY, false},
        {"Infinity", INFINITY, false},
    };
    for (const auto &each : cases) {
        Lexed lexed(each.text);
        ASSERT_EQ(lexed.tokens.size(), 1u) << each.text;
        EXPECT_EQ(lexed.tokens[0].kind, TokenKind::Number) << each.text;
        EXPECT_EQ(lexed.tokens[0].number, each.value) << each.text;
        EXPECT_EQ(lexed.tokens[0].whole, each.whole) << each.text;
        EXPECT_EQ(lexed.found.text(), "") << each.text;
    }
    for (const char *text : {"nan", "NaN", "-nan"})
        EXPECT_TRUE(std::isnan(Lexed(text).tokens[0].number)) << text;
}

// 7.038531e-26 as a double lies on the middle between two floats, and that on the other side.
TEST(Lexer, numbersAreTheNearestFloats) {
    for (const float value : {7.038531e-26f, 1e-45f, 1.17549435e-38f, 1.17549421e-38f,
                              3.40282347e38f, 16777216.f, .1f, 1e22f, 123456.789f}) {
        char text[40];
        std::snprintf(text, sizeof text, "%.9g", double(value));
        for (const std::string &word : {std::string(text), std::string("7.038531e-26")}) {
            const Lexed lexed(word + " ");
            ASSERT_EQ(lexed.tokens.size(), 1u);
            EXPECT_EQ(lexed.tokens[0].single, std::strtof(word.c_str(), nullptr)) << word;
        }
    }
}

TEST(Lexer, whatIsNoNumberIsReportedAndKeepsItsPlace) {
    for (const char *text : {"1.2.3", "--1", "+-1", "1e", "12abc", ".", "0x", "-x", "1,2"}) {
        Lexed lexed(text);
        ASSERT_EQ(lexed.tokens.size(), 1u) << text;
        EXPECT_TRUE(std::isnan(lexed.tokens[0].number)) << text;
        EXPECT_EQ(lexed.found.count(Severity::Error), 1) << text;
    }
}

TEST(Lexer, stringsHaveEscapes) {
    struct {
        const char *text, *expected;
    } cases[] = {
        {R"("a\nb\tc\rd\be\ff")", "a\nb\tc\rd\be\ff"},
        {R"("\\ \" \101\60")", "\\ \" A0"},
        {R"("\1018")", "A8"},
        {R"("\q")", "q"},
        {"\"one\\\ntwo\\\r\nthree\\\rfour\"", "onetwothreefour"},
        {"\"one\ntwo\r\nthree\rfour\"", "one\ntwo\nthree\nfour"},
        {"\"# [ ] Sphere\"", "# [ ] Sphere"},
    };
    for (const auto &each : cases) {
        Lexed lexed(each.text);
        ASSERT_EQ(lexed.tokens.size(), 1u) << each.text;
        EXPECT_EQ(lexed.tokens[0].text, each.expected) << each.text;
        EXPECT_EQ(lexed.found.text(), "") << each.text;
    }
}

TEST(Lexer, unterminatedStringsEndBeforeTheNextRequest) {
    Lexed lexed("Surface \"matte\nSphere 1 -1 1 360\nSurface \"plastic\"\n");
    EXPECT_EQ(lexed.text(), "R(Surface)S(matte)R(Sphere)IIIIR(Surface)S(plastic)");
    EXPECT_EQ(lexed.found.text(),
              "test.rib:1:9: error: unterminated string: expected a closing quote before "
              "the end of the line\n");
    EXPECT_EQ(Lexed("\"\\").found.count(Severity::Error), 1);
    EXPECT_EQ(Lexed("\"abc\n").found.count(Severity::Error), 1);
    EXPECT_EQ(Lexed("\"a\nSphereHead\"").found.count(Severity::Error), 0);
}

TEST(Lexer, placesAreLinesAndColumns) {
    for (const char *lineEnd : {"\n", "\r\n", "\r"}) {
        std::string end = lineEnd;
        Lexed lexed("A" + end + "  B # x" + end + "\"s" + end + "t\" C" + end + end + "D");
        std::vector<std::pair<int, int>> places;
        for (const RibToken &token : lexed.tokens)
            places.emplace_back(token.where.line, token.where.column);
        EXPECT_EQ(places,
                  (std::vector<std::pair<int, int>>{{1, 1}, {2, 3}, {3, 1}, {4, 4}, {6, 1}}));
    }
}

TEST(Lexer, strayBytesAreReportedOnce) {
    Lexed others("{ Sphere } ; Disk");
    EXPECT_EQ(others.text(), "R(Sphere)R(Disk)");
    EXPECT_EQ(others.found.count(Severity::Error), 1);
    std::string everything;
    for (int i = 0; i < 100000; ++i)
        everything += char(i * 7919 >> 3);
    EXPECT_GT(Lexed(everything).found.count(Severity::Error), 0);
}

} // namespace candela
