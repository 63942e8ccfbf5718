// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/lookahead.h"

#include <gtest/gtest.h>

#include "language/syntax/lexer.h"

namespace candela::sl {
namespace {

/// What the words of a text begin, each letter one answer: Name, Type, Declaration, Function,
/// Shader.
std::string begun(const std::string &text, const std::string &declared = "") {
    DiagnosticList diagnostics;
    Reporter reporter(diagnostics);
    SourceFile file("test.sl", text);
    std::vector<Token> words = tokenize(file, reporter);
    TokenCursor tokens(words, reporter);
    Lookahead ahead(tokens);
    ahead.declare(declared);
    return std::string(ahead.isName() ? "N" : "") + (ahead.isTypeWord() ? "T" : "") +
           (ahead.startsDeclaration() ? "D" : "") + (ahead.startsFunction() ? "F" : "") +
           (ahead.startsShader() ? "S" : "");
}

TEST(Lookahead, WhatFollowsDecides) {
    const std::pair<const char *, const char *> table[] = {
        {"x = 1;", "N"},
        {"light = 1;", "N"},
        {"if (x)", ""},
        {"uniform float x;", "D"},
        {"float x;", "TD"},
        {"float (x)", "T"},
        {"normal = N;", "N"},
        {"normal N = 1;", "TD"},
        {"point normal = 1;", "TD"},
        {"vector \"world\" (1, 2, 3)", "T"},
        {"float f(float x) {", "TF"},
        {"float f(x) + 1", "T"},
        {"float f((1 + 2)) {", "TF"},
        {"f(x) {", "NF"},
        {"f(x);", "N"},
        {"f(x", "N"},
        {"surface s(", "NS"},
        {"surface(s)", "N"},
        {"1 + 2", ""},
        {"", ""},
    };
    for (auto [text, expected] : table)
        EXPECT_EQ(begun(text), expected) << text;
}

TEST(Lookahead, BeforeAMinusATypeWordIsANameIfAVariableHasIt) {
    EXPECT_EQ(begun("normal - 1"), "T");
    EXPECT_EQ(begun("normal - 1", "normal"), "N");
    EXPECT_EQ(begun("normal - 1", "vector"), "T");
}

TEST(Lookahead, NamesAreForgottenWithTheirScope) {
    DiagnosticList diagnostics;
    Reporter reporter(diagnostics);
    SourceFile file("test.sl", "color - 1");
    std::vector<Token> words = tokenize(file, reporter);
    TokenCursor tokens(words, reporter);
    Lookahead ahead(tokens);
    {
        Lookahead::InnerScope inner(ahead);
        ahead.declare("color");
        EXPECT_TRUE(ahead.isName());
    }
    EXPECT_FALSE(ahead.isName());
}

} // namespace
} // namespace candela::sl
