// SPDX-License-Identifier: Apache-2.0
// The place in a RIB stream where the arguments of a request are read, and what is said where
// something else stands.
#pragma once

#include "interface/ri/request_table.h"
#include "interface/rib/lexer.h"

#include <string>

namespace candela {

class ArgumentCursor {
public:
    ArgumentCursor(Lexer lexer, DiagnosticSink &diagnostics)
        : lexer_(std::move(lexer)), diagnostics_(diagnostics), token_(lexer_.next()) {}

    const RibToken &token() const { return token_; }
    bool at(TokenKind kind) const { return token_.kind == kind; }
    bool atRequestOrEnd() const { return at(TokenKind::Request) || at(TokenKind::End); }
    void next() { token_ = lexer_.next(); }

    /// Nothing is said of what is wrong, while it is skipped.
    void setSilent(bool silent) { lexer_.setSilent(silent); }

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
