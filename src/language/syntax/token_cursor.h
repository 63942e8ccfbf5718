// SPDX-License-Identifier: Apache-2.0
// The place in the token list where the parser stands, and what it says when it cannot go on.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "language/syntax/reporter.h"
#include "language/syntax/token.h"

namespace candela::sl {

/// Thrown after a report, caught where parsing can start again; never leaves the parser.
struct Panic {};

class TokenCursor {
public:
    using Spellings = std::initializer_list<const char *>;

    /// The tokens end with End, at which the cursor stays.
    TokenCursor(const std::vector<Token> &tokens, Reporter &reporter)
        : tokens_(tokens), reporter_(reporter) {}

    const Token &peek(size_t ahead = 0) const;
    const Token &take();
    bool at(const char *spelling, size_t ahead = 0) const { return peek(ahead).is(spelling); }
    bool atAny(Spellings, size_t ahead = 0) const;
    bool atEnd(size_t ahead = 0) const { return peek(ahead).kind == TokenKind::End; }
    bool accept(const char *spelling);

    /// Panics if something else stands here.
    void expect(const char *spelling, const std::string &context);
    /// A forgotten semicolon is best shown where it belongs; if the next word starts a line,
    /// parsing goes on as if it had been there.
    void expectSemicolon(const std::string &context);
    [[noreturn]] void unexpected(const std::string &expected) const;
    [[noreturn]] void fail(const Place &, const std::string &message) const;
    /// For errors after which parsing goes on, and to see whether it should.
    Reporter &reporter() const { return reporter_; }

    /// Right behind the token before this one.
    Place afterPrevious() const;
    /// Number of tokens before this one.
    size_t position() const { return at_; }
    /// Round brackets that are open here and were not at that position.
    int bracketsOpenedSince(size_t position) const;

    /// Counts how deep the grammar is nested for as long as it lives; too deep is an error, not a
    /// stack overflow.
    class Nesting {
    public:
        explicit Nesting(TokenCursor &);
        ~Nesting() { --cursor_.depth_; }
        Nesting(const Nesting &) = delete;
        Nesting &operator=(const Nesting &) = delete;

    private:
        TokenCursor &cursor_;
    };

private:
    const std::vector<Token> &tokens_;
    Reporter &reporter_;
    size_t at_ = 0;
    int depth_ = 0;
};

} // namespace candela::sl
