// SPDX-License-Identifier: Apache-2.0
// The words of a shader file.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "language/syntax/source.h"

namespace candela::sl {

/// Stray: a byte that begins no word.
enum class TokenKind { End, Identifier, Number, Text, Punctuator, Stray };

/// What is wrong with a word. Told only where the word counts: lines that a condition leaves out,
/// #pragma and #error may hold anything.
struct Flaw {
    Place where;
    std::string message;
};

struct Token {
    TokenKind kind = TokenKind::End;
    std::string spelling; ///< As written; a Text token's with its quotes and escapes.
    std::string text;     ///< Text: the string it stands for.
    double number = 0;    ///< Number: its value.
    Place where;          ///< Of a token out of a macro: where the macro was used.
    bool startsLine = false;
    bool spaceBefore = false;
    /// Macros that this token came out of and that must not expand it again.
    std::shared_ptr<const std::set<std::string>> hidden;
    std::shared_ptr<const Flaw> flaw; ///< Null: none.

    bool is(const char *punctuatorOrWord) const {
        return (kind == TokenKind::Punctuator || kind == TokenKind::Identifier) &&
               spelling == punctuatorOrWord;
    }
    bool isIdentifier() const { return kind == TokenKind::Identifier; }
};

} // namespace candela::sl
