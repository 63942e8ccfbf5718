// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/parser.h"

#include <algorithm>

#include "language/syntax/parser_state.h"

namespace candela::sl {

// Deep enough for any shader that a person or a generator writes, and safe on a small stack.
static constexpr int nestingLimit = 200;

Parser::Nesting::Nesting(Parser &parser) : parser_(parser) {
    if (++parser_.depth_ <= nestingLimit)
        return;
    --parser_.depth_;
    parser_.fail(parser_.peek().where,
                 "nested too deeply; the limit is " + std::to_string(nestingLimit) + " levels");
}

const Token &Parser::peek(size_t ahead) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

const Token &Parser::take() {
    const Token &token = peek();
    if (at_ + 1 < tokens_.size())
        ++at_;
    return token;
}

bool Parser::atAny(Names names, size_t ahead) const {
    return std::ranges::any_of(names, [&](const char *name) { return at(name, ahead); });
}

bool Parser::accept(const char *spelling) {
    if (!at(spelling))
        return false;
    take();
    return true;
}

Place Parser::afterPrevious() const {
    if (at_ == 0)
        return peek().where;
    Place where = tokens_[at_ - 1].where;
    where.column += where.length;
    where.length = 1;
    return where;
}

void Parser::fail(const Place &where, const std::string &message) {
    reporter_.error(where, message);
    throw Panic{};
}

void Parser::unexpected(const std::string &expected) {
    std::string found = atEnd() ? "the end of the file" : "'" + peek().spelling + "'";
    fail(peek().where, "expected " + expected + ", not " + found);
}

void Parser::expect(const char *spelling, const std::string &context) {
    if (!accept(spelling))
        unexpected("'" + std::string(spelling) + "' " + context);
}

// A forgotten semicolon is best shown where it belongs; if the next word starts a line, parsing
// goes on as if it had been there.
void Parser::expectSemicolon(const std::string &context) {
    if (accept(";"))
        return;
    reporter_.error(afterPrevious(), "expected ';' " + context);
    if (!peek().startsLine && !at("}"))
        throw Panic{};
}

size_t Parser::behindBrackets(size_t ahead) const {
    int depth = 0;
    for (size_t i = ahead; !atEnd(i) && !at("{", i) && !at("}", i); ++i) {
        depth += at("(", i) - at(")", i);
        if (depth == 0)
            return i + 1;
    }
    return 0;
}

bool Parser::isReserved(size_t ahead) const {
    return atAny({"if", "else", "while", "for", "break", "continue", "return", "extern", "uniform",
                  "varying"},
                 ahead);
}

// 3.1 shaders call their variables "normal" or "vector": a type word is a name where a type makes
// no sense. Before a '-' both make sense; there it is a name if a variable is called so.
bool Parser::isName(size_t ahead) const {
    if (!peek(ahead).isIdentifier() || isReserved(ahead))
        return false;
    return !baseTypeNamed(peek(ahead).spelling) ||
           (at("-", ahead + 1) && namedAsTypes_.contains(peek(ahead).spelling)) ||
           atAny({"=", "+=", "-=", "*=", "/=", ";",  ",",  ")",  "]",  ".", "*", "/", "^",
                  "+", "==", "!=", "<",  ">",  "<=", ">=", "&&", "||", "?", ":", "["},
                 ahead + 1);
}

bool Parser::isTypeWord(size_t ahead) const {
    return peek(ahead).isIdentifier() && baseTypeNamed(peek(ahead).spelling) && !isName(ahead);
}

std::string Parser::takeName(const std::string &what, Place &where) {
    if (!isName())
        unexpected(what);
    where = peek().where;
    return take().spelling;
}

ast::File parse(const std::vector<Token> &tokens, Reporter &reporter) {
    return Parser(tokens, reporter).file();
}

} // namespace candela::sl
