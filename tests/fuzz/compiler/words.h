// SPDX-License-Identifier: Apache-2.0
// A shader's text as the words that are mutated. Not the compiler's lexer: what that has wrong
// must not decide what it is tried on.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace candela::fuzz {

struct Word {
    std::string space; ///< Blanks, line ends and comments before it.
    std::string text;  ///< Empty for what stands behind the last word.
};
using Words = std::vector<Word>;

Words wordsOf(std::string_view text);
std::string textOf(const Words &);

bool isNumber(const Word &);
bool isName(const Word &);
bool isString(const Word &);
/// The word is the first of its line.
bool startsLine(const Words &, std::size_t at);

/// Part of a text: words from `begin` to before `end`.
struct Span {
    std::size_t begin = 0, end = 0;
};
Words copyOf(const Words &, Span);
/// Puts `piece` in the place of the span's words.
void replace(Words &, Span, const Words &piece);

/// What stands in one pair of brackets ( ), [ ] or { }, brackets included; one that has no partner
/// reaches to the text's end.
std::vector<Span> groupsOf(const Words &);
/// What stands between the commas of ( ) and { }.
std::vector<Span> argumentsOf(const Words &);
/// From behind a ; { or } to the next ; that stands in no inner bracket, or to the end of a block.
std::vector<Span> statementsOf(const Words &);
std::vector<Span> linesOf(const Words &);

} // namespace candela::fuzz
