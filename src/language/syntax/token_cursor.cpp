// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/token_cursor.h"

#include <algorithm>

namespace candela::sl {

// Deep enough for any shader that a person or a generator writes, and safe on a small stack.
static constexpr int nestingLimit = 200;

TokenCursor::Nesting::Nesting(TokenCursor &cursor) : cursor_(cursor) {
    if (++cursor_.depth_ <= nestingLimit)
        return;
    --cursor_.depth_;
    cursor_.fail(cursor_.peek().where,
                 "nested too deeply; the limit is " + std::to_string(nestingLimit) + " levels");
}

const Token &TokenCursor::peek(size_t ahead) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

const Token &TokenCursor::take() {
    const Token &token = peek();
    if (at_ + 1 < tokens_.size())
        ++at_;
    return token;
}

bool TokenCursor::atAny(Spellings spellings, size_t ahead) const {
    return std::ranges::any_of(spellings, [&](const char *s) { return at(s, ahead); });
}

bool TokenCursor::accept(const char *spelling) {
    if (!at(spelling))
        return false;
    take();
    return true;
}

void TokenCursor::expect(const char *spelling, const std::string &context) {
    if (!accept(spelling))
        unexpected("'" + std::string(spelling) + "' " + context);
}

void TokenCursor::expectSemicolon(const std::string &context) {
    if (accept(";"))
        return;
    reporter_.error(afterPrevious(), "expected ';' " + context);
    if (!peek().startsLine && !at("}"))
        throw Panic{};
}

void TokenCursor::unexpected(const std::string &expected) const {
    std::string found = atEnd() ? "the end of the file" : "'" + peek().spelling + "'";
    fail(peek().where, "expected " + expected + ", not " + found);
}

void TokenCursor::fail(const Place &where, const std::string &message) const {
    reporter_.error(where, message);
    throw Panic{};
}

Place TokenCursor::afterPrevious() const {
    if (at_ == 0)
        return peek().where;
    Place where = tokens_[at_ - 1].where;
    where.column += where.length;
    where.length = 1;
    return where;
}

int TokenCursor::bracketsOpenedSince(size_t position) const {
    int depth = 0;
    for (size_t i = position; i < at_; ++i)
        depth = std::max(0, depth + tokens_[i].is("(") - tokens_[i].is(")"));
    return depth;
}

} // namespace candela::sl
