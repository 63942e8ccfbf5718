// SPDX-License-Identifier: Apache-2.0
// The place in a RIB stream where the arguments of a request are read, and what is said where
// something else stands.
#pragma once

#include "interface/ri/request_table.h"
#include "interface/rib/lexer.h"

#include <span>
#include <string>
#include <vector>

namespace candela {

class ArgumentCursor {
public:
    ArgumentCursor(Lexer lexer, DiagnosticSink &diagnostics)
        : lexer_(std::move(lexer)), diagnostics_(diagnostics) {
        next();
    }

    const RibToken &token() const { return token_; }
    bool at(TokenKind kind) const { return token_.kind == kind; }
    bool atRequestOrEnd() const { return at(TokenKind::Request) || at(TokenKind::End); }
    void next() { lexer_.next(token_); }
    // At '[' or a number of an array, which is passed: the numbers behind it are put there, as many
    // as can be had at once, and the token behind those comes next.
    template <class Value> void nextNumbers(std::vector<Value> &values) {
        lexer_.takeNumbers(values);
        next();
    }
    std::size_t nextNumbers(std::span<float> room) {
        const std::size_t count = lexer_.takeNumbers(room);
        next();
        return count;
    }

    /// Nothing is said of what is wrong, while it is skipped.
    void setSilent(bool silent) { lexer_.setSilent(silent); }
    /// Those passed so far, if the lexer keeps them.
    std::vector<RibComment> takeComments() { return lexer_.takeComments(); }

    /// At the name of a request: its arguments come now.
    void begin(const RequestDescription &);
    /// Messages name the argument of that index; -1 for none.
    void setArgument(int index) { argument_ = index; }
    int argument() const { return argument_; }

    /// Brackets may stand around any run of arguments of fixed number: Sphere [1 -1 1 360].
    void openBracket();
    void closeBracket();
    /// True if no such bracket is open any more; otherwise reported.
    bool bracketsClosed();
    /// True if nothing is left over before the next request; otherwise reported.
    bool atEndOfArguments();
    /// What follows something wrong is silently passed, up to the next request that is one.
    void skipToRequest();

    /// Reports that something else stands here; false, for the caller to return.
    bool expected(const std::string &what);
    /// An error of the request.
    void error(const SourceLocation &, const std::string &message);

private:
    Lexer lexer_;
    DiagnosticSink &diagnostics_;
    RibToken token_;
    const RequestDescription *request_ = nullptr;
    int argument_ = -1;
    bool inBracket_ = false;
};

/// A token as messages name it.
std::string describe(const RibToken &);

} // namespace candela
