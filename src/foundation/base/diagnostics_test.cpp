// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/diagnostics.h"

#include <gtest/gtest.h>
#include <sstream>

namespace candela {

namespace {

constexpr int quotedLength = 120; // Bytes of a line that are shown at most.

/// The second and the third line of what is printed: the quoted one and the caret's.
std::pair<std::string, std::string> quoted(const std::string &line, int column, int length = 1) {
    Diagnostic diagnostic;
    diagnostic.severity = Severity::Error;
    diagnostic.where.line = 1, diagnostic.where.column = column;
    diagnostic.message = "m", diagnostic.sourceLine = line, diagnostic.caretLength = length;
    std::istringstream text(format(diagnostic));
    std::string message, quote, caret;
    std::getline(text, message);
    std::getline(text, quote);
    std::getline(text, caret);
    return {quote, caret};
}

} // namespace

TEST(Diagnostics, ShortLinesAreQuotedWhole) {
    const std::string line = "\tx = yes;" + std::string(quotedLength - 9, '-');
    for (int column = 0; column <= quotedLength + 9; ++column)
        EXPECT_EQ(quoted(line, column).first, "    " + line);
    EXPECT_EQ(quoted(line, 6, 3).second, "    \t    ^~~");
    EXPECT_EQ(quoted("x", 40).second, "     ^");
    EXPECT_EQ(quoted("x", 0).second, "    ^");
}

// At every column the caret's character is the line's, and no quote is longer than it may be.
TEST(Diagnostics, LongLinesAreQuotedAroundTheColumn) {
    std::string line;
    for (int i = 0; i < 2500; ++i)
        line += char('a' + i * i % 26);
    for (int column = 1; column <= int(line.size()); ++column) {
        const auto [quote, caret] = quoted(line, column, 2500);
        EXPECT_LE(quote.size(), size_t(4 + 3 + quotedLength + 3));
        EXPECT_LE(caret.size(), quote.size());
        const size_t place = caret.find('^');
        ASSERT_LT(place, quote.size()) << column;
        EXPECT_EQ(quote[place], line[column - 1]) << column;
        const size_t before = std::min(column - 1, 20);
        EXPECT_EQ(quote.substr(place - before, before), line.substr(column - 1 - before, before));
    }
    EXPECT_EQ(quoted(line, 1).first, "    " + line.substr(0, quotedLength) + "...");
    EXPECT_EQ(quoted(line, 2500).first, "    ..." + line.substr(2500 - quotedLength));
}

TEST(Diagnostics, CharactersOfSeveralBytesAreNotCut) {
    std::string line;
    for (int i = 0; i < 500; ++i)
        line += "\u00e9";
    for (int column = 1; column < 1000; column += 2) {
        const std::string quote = quoted(line, column).first;
        const size_t begin = quote.find('\xc3'), end = quote.rfind('\xa9');
        EXPECT_EQ(quote.substr(0, begin), begin == 4 ? "    " : "    ...");
        EXPECT_TRUE(end + 1 == quote.size() || quote.substr(end + 1) == "...") << column;
    }
}

// Terminals do not obey files, and the caret stays below its place.
TEST(Diagnostics, ControlsAreEscaped) {
    EXPECT_EQ(quoted("a\x1b[2Jb\tc", 7).first, "    a\\x1b[2Jb\tc");
    EXPECT_EQ(quoted("a\x1b[2Jb\tc", 6).second, "            ^");
    EXPECT_EQ(quoted("a\x1b[2Jb\tc", 2).second, "     ^~~~");
    EXPECT_EQ(quoted("\xff\xff", 2, 1).second, "        ^~~~");
    Diagnostic diagnostic;
    diagnostic.where.file = std::make_shared<const std::string>("a\nb.sl");
    diagnostic.where.line = 3;
    diagnostic.message = "no \x1b[31m, \n" + std::string(1 << 20, 'x');
    const std::string text = format(diagnostic);
    EXPECT_TRUE(text.starts_with("a\\nb.sl:3: error: no \\x1b[31m, \\nxxx")) << text;
    EXPECT_LT(text.size(), 400u);
}

} // namespace candela
