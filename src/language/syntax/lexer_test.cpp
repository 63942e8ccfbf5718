// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/lexer.h"

#include <gtest/gtest.h>

namespace candela::sl {
namespace {

struct Lexed {
    DiagnosticList diagnostics;
    std::unique_ptr<SourceFile> file;
    std::vector<Token> tokens;

    explicit Lexed(std::string_view text) : file(std::make_unique<SourceFile>("test.sl", text)) {
        Reporter reporter(diagnostics);
        tokens = tokenize(*file, reporter);
        for (const Token &token : tokens)
            if (token.flaw)
                reporter.error(token.flaw->where, token.flaw->message);
    }

    std::string spellings() const {
        std::string result;
        for (size_t i = 0; i + 1 < tokens.size(); ++i)
            result += (i ? " " : "") + tokens[i].spelling;
        return result;
    }
};

TEST(Lexer, SplitsIntoWords) {
    const std::pair<const char *, const char *> table[] = {
        {"a+b", "a + b"},
        {"a+=b==c", "a += b == c"},
        {"Ln.Nn<=.5", "Ln . Nn <= .5"},
        {"1.5e-3*2.", "1.5e-3 * 2."},
        {"x/**/y//z\nw", "x y w"},
        {"a&&b||!c", "a && b || ! c"},
        {"__a_1 Du()", "__a_1 Du ( )"},
    };
    for (auto [text, expected] : table) {
        Lexed lexed(text);
        EXPECT_EQ(lexed.spellings(), expected);
        EXPECT_EQ(lexed.diagnostics.all().size(), 0u) << text;
    }
}

TEST(Lexer, ReadsNumbers) {
    const std::pair<const char *, double> table[] = {{"0", 0},  {"12", 12},    {".25", .25},
                                                     {"3.", 3}, {"1e3", 1000}, {"2.5E-2", .025}};
    for (auto [text, expected] : table) {
        Lexed lexed(text);
        ASSERT_EQ(lexed.tokens.size(), 2u);
        EXPECT_EQ(lexed.tokens[0].kind, TokenKind::Number);
        EXPECT_EQ(lexed.tokens[0].number, expected);
    }
}

TEST(Lexer, ReadsStringEscapes) {
    Lexed lexed(R"("a\n\t\"\\\101\q")");
    ASSERT_EQ(lexed.tokens.size(), 2u);
    EXPECT_EQ(lexed.tokens[0].text, "a\n\t\"\\Aq");
}

TEST(Lexer, KnowsPlacesForAllLineEnds) {
    for (const char *text : {"a\n  bcd\n", "a\r\n  bcd", "a\r  bcd\r"}) {
        Lexed lexed(text);
        ASSERT_EQ(lexed.tokens.size(), 3u);
        EXPECT_EQ(lexed.tokens[1].where.line, 2);
        EXPECT_EQ(lexed.tokens[1].where.column, 3);
        EXPECT_EQ(lexed.tokens[1].where.length, 3);
        EXPECT_TRUE(lexed.tokens[1].startsLine);
    }
}

TEST(Lexer, JoinsContinuedLines) {
    Lexed lexed("al\\\npha \\\r\n beta");
    EXPECT_EQ(lexed.spellings(), "alpha beta");
    EXPECT_FALSE(lexed.tokens[1].startsLine);
    EXPECT_EQ(lexed.tokens[1].where.line, 3);
}

TEST(Lexer, JoinsLinesAlsoWithBlanksBehindTheBackslash) {
    Lexed lexed("al\\ \t\npha \\ \r\n beta");
    EXPECT_EQ(lexed.diagnostics.text(), "");
    EXPECT_EQ(lexed.spellings(), "alpha beta");
    EXPECT_FALSE(lexed.tokens[1].startsLine);
    EXPECT_EQ(lexed.tokens[1].where.line, 3);
}

TEST(Lexer, ACommentOfSeveralLinesIsABlank) {
    Lexed lexed("a /* \n */ b\n/* \n */ c");
    ASSERT_EQ(lexed.tokens.size(), 4u);
    EXPECT_FALSE(lexed.tokens[1].startsLine);
    EXPECT_TRUE(lexed.tokens[1].spaceBefore);
    EXPECT_TRUE(lexed.tokens[2].startsLine);
}

TEST(Lexer, KeepsComments) {
    Lexed lexed("// one \nx /** two\n three */ y");
    ASSERT_EQ(lexed.file->comments.size(), 2u);
    EXPECT_EQ(lexed.file->comments[0].text, "one");
    EXPECT_EQ(lexed.file->comments[1].firstLine, 2);
    EXPECT_EQ(lexed.file->comments[1].lastLine, 3);
}

TEST(Lexer, ReportsWhatItCannotRead) {
    const std::pair<const char *, const char *> table[] = {
        {"a \"open\nb", "test.sl:1:3: error: string is not closed; expected '\"' before the end of "
                        "the line"},
        {"a\n /* open", "test.sl:2:2: error: comment is not closed; expected '*/' before the end "
                        "of file"},
        {"a @ b", "test.sl:1:3: error: stray character '@' outside of a string or comment"},
        {"a \xe4 b", "test.sl:1:3: error: stray character with code 228 outside of a string or "
                     "comment"},
        {"12abc", "test.sl:1:3: error: letters stand directly after the number 12; expected an "
                  "operator between them"},
    };
    for (auto [text, expected] : table) {
        std::string found = Lexed(text).diagnostics.text();
        EXPECT_EQ(found.substr(0, found.find('\n')), expected);
    }
}

TEST(Lexer, ForeignBytesInCommentsAndStringsAreFine) {
    EXPECT_EQ(Lexed("/* \xe4\xf6 */ \"\xfc\" // \xff").diagnostics.all().size(), 0u);
}

TEST(Lexer, GivesUpOnRubbish) {
    Lexed lexed(std::string(100000, '\x01'));
    EXPECT_LE(lexed.diagnostics.all().size(), size_t(Reporter::errorLimit) + 1);
}

} // namespace
} // namespace candela::sl
