// SPDX-License-Identifier: Apache-2.0
// The requests of one RIB stream: their names, their arguments read by type, and what to do when
// something else stands there. Private to the room.
#pragma once

#include "interface/rib/lexer.h"
#include "interface/rib/rib_reader.h"

#include <optional>
#include <span>
#include <string>

namespace candela {

class RequestReader {
public:
    RequestReader(RibReader &, Lexer);

    /// Reads requests until the stream ends or the sink wants no more.
    void run();

    // The requests of the stream itself, in the form of a sink's.
    void version(const SourceLocation &, float number);
    void readArchive(const SourceLocation &, const std::string &name, const TokenList &);

    // One argument each: true if it was there; otherwise reported.
    bool read(float &);
    bool read(int &);
    bool read(bool &);
    bool read(std::string &);
    bool read(Handle &);
    bool read(Color &);
    bool read(Matrix4 &);
    bool read(BasisArgument &);
    bool read(Floats &);
    bool read(Integers &);
    bool read(Strings &);
    bool read(LooseFloats &);
    bool read(SubdivisionTags &);
    bool read(TokenList &);

    /// True if nothing is left over before the next request; otherwise reported.
    bool argumentsEnd();
    void skipToRequest();
    RequestSink &sink() { return reader_.sink_; }

private:
    void next() { token_ = lexer_.next(); }
    bool at(TokenKind kind) const { return token_.kind == kind; }
    bool atRequestOrEnd() const { return at(TokenKind::Request) || at(TokenKind::End); }
    void openBracket();
    void closeBracket();
    bool numbers(std::span<float>);
    bool integer(int &);
    bool expected(const std::string &what);
    void error(const SourceLocation &, const std::string &message);
    /// Names the argument that is being read.
    std::string argument() const;
    std::optional<TokenValue> tokenValue();
    bool arrayValues(TokenValue &);
    void skipArray();

    RibReader &reader_;
    Lexer lexer_;
    RibToken token_;
    std::string_view request_;
    std::span<const std::string_view> argumentNames_;
    int argumentIndex_ = -1;
    bool inBracket_ = false;
};

} // namespace candela
