// SPDX-License-Identifier: Apache-2.0
// ASCII RIB as tokens (RI 3.2, appendix C.1).
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/rib/byte_source.h"

#include <memory>
#include <string>

namespace candela {

enum class TokenKind { Request, Number, String, ArrayBegin, ArrayEnd, End };

struct RibToken {
    TokenKind kind = TokenKind::End;
    SourceLocation where;
    std::string text;   ///< A request's name; a string's bytes; a number as written.
    double number = 0;  ///< Of a number.
    bool whole = false; ///< The number was written as an integer.
};

/// Comments and blanks vanish. What is no token is reported and skipped. All three line ends
/// (LF, CRLF, CR) count as one; bytes above 127 may stand in comments and strings, and a UTF-8 byte
/// order mark before everything.
class Lexer {
public:
    /// `file` is the name that locations carry.
    Lexer(std::unique_ptr<ByteSource>, std::string file, DiagnosticSink &);

    RibToken next();
    /// Whether what is wrong is said.
    void setSilent(bool silent) { silent_ = silent; }

private:
    /// What older readers took for what it was meant to be.
    enum class Slip { Quotes, Separators };
    /// Warns once a file.
    void forgive(Slip, const SourceLocation &, const std::string &message);
    void error(const SourceLocation &, const std::string &message);
    int peek(std::size_t ahead = 0) { return source_->peek(ahead); }
    void advance();
    void skipBlanks();
    bool atNumber();
    RibToken request(RibToken);
    RibToken number(RibToken);
    RibToken string(RibToken);
    void escape(std::string &text);
    bool requestFollowsLineEnd();
    void skipStrayBytes(const SourceLocation &);

    std::unique_ptr<ByteSource> source_;
    std::shared_ptr<const std::string> file_;
    DiagnosticSink &diagnostics_;
    int line_ = 1, column_ = 1;
    bool strayReported_[2] = {}, failureReported_ = false, silent_ = false;
    bool forgiven_[2] = {};
};

} // namespace candela
