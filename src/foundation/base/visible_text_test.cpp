// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/visible_text.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(VisibleText, ControlsAndBrokenCharactersAreEscaped) {
    const std::pair<std::string, const char *> table[] = {
        {"plain text\\n", "plain text\\n"},
        {"a\nb\tc\rd", "a\\nb\\tc\\rd"},
        {"\x1b[31mred", "\\x1b[31mred"},
        {std::string("a\0b", 3), "a\\x00b"},
        {"\x7f", "\\x7f"},
        {"\u00e9 \u4e2d \U0001f600", "\u00e9 \u4e2d \U0001f600"},
        {"\xe9", "\\xe9"},                            // Latin 1.
        {"\xc3", "\\xc3"},                            // Half a character.
        {"\xc3z", "\\xc3z"},                          //
        {"\x80", "\\x80"},                            // The other half.
        {"\xc0\xaf", "\\xc0\\xaf"},                   // '/' in two bytes.
        {"\xe0\x80\xaf", "\\xe0\\x80\\xaf"},          // And in three.
        {"\xed\xa0\x80", "\\xed\\xa0\\x80"},          // A surrogate.
        {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"}, // Beyond the last.
        {"\xff\xfe", "\\xff\\xfe"},
        {"\xc2\x9b", "\\xc2\\x9b"},    // CSI, which terminals obey.
        {"\u202e", "\\xe2\\x80\\xae"}, // From right to left from here on.
    };
    for (const auto &[text, expected] : table)
        EXPECT_EQ(visible(text), expected);
    EXPECT_EQ(visible("a\tb\n", "\t"), "a\tb\\n");
}

TEST(VisibleText, ControlsAreFound) {
    for (const char *text : {"a\nb", "\x1b[31m", "\x7f", "\xc2\x9b", "\u202egpj.exe"})
        EXPECT_TRUE(hasControls(text)) << text;
    for (const char *text : {"", "a b", "\u00e9\u4e2d",
                             "b\xfc"
                             "cher.tif",
                             "\x80"}) // Latin 1 is none.
        EXPECT_FALSE(hasControls(text)) << text;
}

TEST(VisibleText, TellsWhereBytesStand) {
    std::vector<std::size_t> places;
    EXPECT_EQ(visible("a\x1b\u00e9z", "", &places), "a\\x1b\u00e9z");
    EXPECT_EQ(places, (std::vector<std::size_t>{0, 1, 5, 6, 7, 8}));
}

TEST(VisibleText, LongWordsAndTextsAreShortened) {
    const std::string longest(60, 'x'), path = "/" + std::string(299, 'x'), longer(1 << 20, 'x');
    for (const std::string &whole : {longest, path})
        EXPECT_EQ(shortened("no " + whole + " here"), "no " + whole + " here");
    const std::string text = shortened("no '" + longer + "' here");
    EXPECT_LT(text.size(), 75u);
    EXPECT_LT(shortened("no /" + longer + " here").size(), 315u);
    EXPECT_TRUE(text.starts_with("no 'xxx") && text.ends_with("xxx' here")) << text;
    EXPECT_NE(text.find("x...x"), std::string::npos);
    std::string words;
    for (int i = 0; i < 100000; ++i)
        words += "word ";
    EXPECT_LT(shortened(words).size(), 3010u);
    std::string accents;
    for (int i = 0; i < 1000; ++i)
        accents += "\u00e9";
    EXPECT_EQ(visible(shortened(accents)), shortened(accents)); // None is cut.
}

} // namespace
} // namespace candela
