// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/lookahead.h"

#include <algorithm>
#include <iterator>

#include "language/syntax/base_type.h"

namespace candela::sl {

bool isReserved(const Token &token) {
    static constexpr const char *words[] = {"if",       "else",   "while",  "for",     "break",
                                            "continue", "return", "extern", "uniform", "varying"};
    return std::ranges::any_of(words, [&](const char *word) { return token.is(word); });
}

// 3.1 shaders call their variables "normal" or "vector": a type word is a name where a type makes
// no sense. Before a '-' both make sense; there it is a name if a variable is called so.
bool Lookahead::isName(size_t ahead) const {
    const Token &word = tokens_.peek(ahead);
    if (!word.isIdentifier() || isReserved(word))
        return false;
    return !baseTypeNamed(word.spelling) ||
           (tokens_.at("-", ahead + 1) && namedAsTypes_.contains(word.spelling)) ||
           tokens_.atAny({"=", "+=", "-=", "*=", "/=", ";",  ",",  ")",  "]",  ".", "*", "/", "^",
                          "+", "==", "!=", "<",  ">",  "<=", ">=", "&&", "||", "?", ":", "["},
                         ahead + 1);
}

bool Lookahead::isTypeWord(size_t ahead) const {
    const Token &word = tokens_.peek(ahead);
    return word.isIdentifier() && baseTypeNamed(word.spelling) && !isName(ahead);
}

bool Lookahead::startsSpecifier() const {
    return isTypeWord() || tokens_.atAny({"uniform", "varying", "extern"}) ||
           (tokens_.at("output") && tokens_.peek(1).isIdentifier());
}

bool Lookahead::startsDeclaration() const {
    if (tokens_.atAny({"uniform", "varying", "extern"}))
        return true;
    return isTypeWord() && isName(1) && !tokens_.at("(", 2);
}

// A definition is told from a call by what follows the brackets.
bool Lookahead::startsFunction() const {
    const size_t type = behindDetail(), behind = behindHead();
    if (behind == 0)
        return false;
    return tokens_.at("{", behind) ||
           (isTypeWord(type) &&
            (isTypeWord(behind) || tokens_.atAny({"uniform", "varying", "output"}, behind)));
}

bool Lookahead::startsPrototype() const {
    const size_t behind = behindHead();
    return behind > 0 && isTypeWord(behindDetail()) && tokens_.at(";", behind);
}

/// How far ahead what follows the words "uniform" and "varying" is.
size_t Lookahead::behindDetail() const {
    size_t ahead = 0;
    while (tokens_.atAny({"uniform", "varying"}, ahead))
        ++ahead;
    return ahead;
}

/// How far ahead the token behind [detail] [type] name(...) is; 0 if no such head stands here.
size_t Lookahead::behindHead() const {
    const size_t type = behindDetail(), name = type + isTypeWord(type);
    const Token &word = tokens_.peek(name);
    const bool isHead =
        word.isIdentifier() && !isReserved(word) && !isTypeWord(name) && tokens_.at("(", name + 1);
    return isHead ? behindBrackets(name + 1) : 0;
}

bool Lookahead::startsShader() const {
    return tokens_.peek().isIdentifier() && shaderKindNamed(tokens_.peek().spelling) &&
           tokens_.peek(1).isIdentifier() && tokens_.at("(", 2);
}

/// How far ahead the token behind the bracket is that closes the one at `ahead`; 0 if none does.
size_t Lookahead::behindBrackets(size_t ahead) const {
    int depth = 0;
    for (size_t i = ahead; !tokens_.atEnd(i) && !tokens_.at("{", i) && !tokens_.at("}", i); ++i) {
        depth += tokens_.at("(", i) - tokens_.at(")", i);
        if (depth == 0)
            return i + 1;
    }
    return 0;
}

void Lookahead::declare(const std::string &name) {
    if (baseTypeNamed(name))
        namedAsTypes_.insert(name);
}

} // namespace candela::sl
