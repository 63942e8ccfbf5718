// SPDX-License-Identifier: Apache-2.0
// What the campaign's inputs are made of, and that they are the same each time.
#include "chance.h"
#include "expressions.h"
#include "inputs.h"
#include "reduce.h"
#include "trial.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace candela::fuzz {
namespace {

const std::string folder = CANDELA_SOURCE_DIR "/tests/fuzz/compiler/corpus";

TEST(Words, AreTheTextAgain) {
    Chance chance(1);
    const std::string_view bytes = "ab_1.5e+\"\\/*\n ({[]})=<;,#";
    for (int round = 0; round < 2000; ++round) {
        std::string text;
        for (std::size_t n = chance.below(30); n > 0; --n)
            text += chance.oneIn(20) ? char(chance.below(256)) : bytes[chance.below(bytes.size())];
        EXPECT_EQ(textOf(wordsOf(text)), text);
    }
}

std::set<std::string> textsOf(const Words &words, std::vector<Span> (*parts)(const Words &)) {
    std::set<std::string> texts;
    for (const Span &span : parts(words)) {
        Words piece = copyOf(words, span);
        piece.front().space.clear();
        texts.insert(textOf(piece));
    }
    return texts;
}

TEST(Words, HaveParts) {
    const Words words = wordsOf("for (i = 0; i < 2; i += 1) { x = f(a, 1.5e-3); }\ny += \"; {\";");
    using Texts = std::set<std::string>;
    EXPECT_EQ(textsOf(words, groupsOf),
              (Texts{"(i = 0; i < 2; i += 1)", "(a, 1.5e-3)", "{ x = f(a, 1.5e-3); }"}));
    EXPECT_EQ(textsOf(words, statementsOf),
              (Texts{"x = f(a, 1.5e-3);", "{ x = f(a, 1.5e-3); }", "y += \"; {\";"}));
    EXPECT_EQ(textsOf(words, argumentsOf),
              (Texts{"i = 0; i < 2; i += 1", "a", "1.5e-3", "x = f(a, 1.5e-3);"}));
    EXPECT_EQ(textsOf(words, linesOf),
              (Texts{"for (i = 0; i < 2; i += 1) { x = f(a, 1.5e-3); }", "y += \"; {\";"}));
}

TEST(Inputs, AreMadeOfTheirSeed) {
    const TrialSettings settings;
    const Accepts accepts = [&](const std::string &text) { return compiles(text, settings); };
    const Corpus corpus = readCorpus({folder}), again = readCorpus({folder});
    std::set<std::string> texts;
    for (const InputKind kind : {InputKind::MutatedShader, InputKind::TokenStream})
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            const std::string text = makeInput({kind, seed}, corpus, accepts);
            EXPECT_EQ(makeInput({kind, seed}, again, accepts), text);
            texts.insert(text);
        }
    EXPECT_GE(texts.size(), 115u);
}

/// Else mutations of them would be refused without a look.
TEST(Inputs, StartFromShadersThatCompile) {
    const Corpus corpus = readCorpus({folder});
    ASSERT_GE(corpus.texts.size(), 3u);
    for (const Words &words : corpus.texts)
        EXPECT_TRUE(compiles(textOf(words), {})) << textOf(words);
}

/// Mistakes of type or place would hide what the statements are for.
TEST(Expressions, CompileMostly) {
    Chance chance(3);
    int good = 0;
    for (int n = 0; n < 300; ++n) {
        const std::string text =
            "surface s() { Ci = Cs; Oi = Os; " + randomStatement(chance) + " }";
        good += compiles(text, {});
    }
    EXPECT_GE(good, 270);
}

TEST(Reduce, KeepsWhatFails) {
    const auto fails = [](const std::string &text) {
        const Words words = wordsOf(text);
        const auto has = [&](const char *word) {
            return std::ranges::find(words, word, &Word::text) != words.end();
        };
        return has("bad") && has("worse");
    };
    EXPECT_EQ(reduceText("a { bad; b(c, d, /* e */ worse); }\n f", fails), "bad worse");
}

} // namespace
} // namespace candela::fuzz
