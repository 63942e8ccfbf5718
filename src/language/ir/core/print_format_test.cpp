// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/print_format.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::ir {
namespace {

struct Case {
    const char *pattern;
    float number;
    const char *expected;
};

TEST(PrintFormat, Numbers) {
    const Case table[] = {
        {"%f", 2, "2.000000"},
        {"%d", 3, "3"},
        {"%d", 2.6f, "3"},
        {"%i", -2.6f, "-3"},
        {"%d", -0.2f, "0"},
        {"%04d|", 7, "0007|"},
        {"%-4d|", 7, "7   |"},
        {"%.3d", 7, "007"},
        {"%#d", 7, "7"},
        {"%d", 1e30f, "1000000015047466219876688855040.000000"},
        {"%d", INFINITY, "inf"},
        {"%.2f", 2.345f, "2.35"},
        {"%8.1f|", 2.25f, "     2.2|"},
        {"%+.0f", 2, "+2"},
        {"%.f", 2, "2"},
        {"%g", 0.5f, "0.5"},
        {"%.1e", 1234, "1.2e+03"},
        {"%%%g%%", 1, "%1%"},
        {"%--++08.2f", 1, "+1.00   "},
        {"%5.5.5f", 1, "1.00000"},
        {"a%", 1, "a1.000000"},
    };
    for (const auto &[pattern, number, expected] : table)
        EXPECT_EQ(formatPrint(pattern, {{number, nullptr}}), expected) << pattern;
}

TEST(PrintFormat, TriplesAndStrings) {
    EXPECT_EQ(formatPrint("(%.1c)", {{1, nullptr}, {2, nullptr}, {3, nullptr}}), "(1.0 2.0 3.0)");
    const std::string word = "word";
    EXPECT_EQ(formatPrint("%6s|%-6s|%.2s|%s", {{0, &word}, {0, &word}, {0, &word}}),
              "  word|word  |wo|");
}

TEST(PrintFormat, WidthsAreBounded) {
    EXPECT_EQ(formatPrint("%999999999d", {{1, nullptr}}).size(), 128u);
    EXPECT_EQ(formatPrint("%.99999999999999999999f", {{1, nullptr}}).size(), 130u);
}

} // namespace
} // namespace candela::ir
