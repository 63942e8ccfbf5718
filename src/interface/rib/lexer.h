// SPDX-License-Identifier: Apache-2.0
// RIB as tokens: ASCII (RI 3.2, appendix C.1) and binary (C.2), which may alternate.
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/rib/byte_source.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace candela {

enum class TokenKind { Request, Number, String, ArrayBegin, ArrayEnd, End };

struct RibToken {
    TokenKind kind = TokenKind::End;
    SourceLocation where;
    std::string text;   ///< A request's name; a string's bytes.
    double number = 0;  ///< Of a number,
    float single = 0;   ///< and as the float that is nearest to what is written.
    bool whole = false; ///< The number was written as an integer.
};

struct RibComment {
    SourceLocation where;
    std::string text; ///< Behind the first '#'.
};

/// Comments and blanks vanish. What is no token is reported and skipped. All three line ends
/// (LF, CRLF, CR) count as one; bytes above 127 may stand in ASCII comments and strings, and a
/// UTF-8 byte order mark before everything. In binary parts columns count bytes.
class Lexer {
public:
    /// `file` is the name that locations carry.
    Lexer(std::unique_ptr<ByteSource>, std::string file, DiagnosticSink &);

    void next(RibToken &);
    // The numbers that come next, as long as they are of the plain sort that long arrays hold: what
    // ends them is next()'s. Many times as fast as that.
    void takeNumbers(std::vector<float> &);
    void takeNumbers(std::vector<int> &);
    /// No more than there is room for; how many they are.
    std::size_t takeNumbers(std::span<float> room);

    /// Whether what is wrong is said.
    void setSilent(bool silent) { silent_ = silent; }
    /// Ends at a byte of 0377 between tokens, which ends what programs answer.
    void endAtMark() { endsAtMark_ = true; }
    /// Comments passed so far, if they are kept, and not yet taken.
    void keepComments() { keepsComments_ = true; }
    std::vector<RibComment> takeComments() { return std::move(comments_); }

private:
    /// What older readers took for what it was meant to be.
    enum class Slip { Quotes, Separators };
    /// Warns once a file.
    void forgive(Slip, const SourceLocation &, const std::string &message);
    void error(const SourceLocation &, const std::string &message);

    int peek(std::size_t ahead = 0) { return source_->peek(ahead); }
    int column() const;
    SourceLocation here() const;
    void advance();
    /// Bytes that are no line ends.
    void skip(std::size_t count);
    void skipBlanks();
    void comment();
    void end(const SourceLocation &);
    bool readToken(RibToken &);
    bool atNumber();
    void request(RibToken &);
    void number(RibToken &);
    void string(RibToken &);
    void escape(std::string &text);
    bool requestFollowsLineEnd();
    void skipStrayBytes(const SourceLocation &);
    template <class Room> void takePlainNumbers(Room &);

    // Binary: binary_tokens.cpp.
    bool binary(RibToken &);
    void binaryNumber(RibToken &, int code);
    double binaryValue(int code);
    void binaryString(RibToken &, std::uint64_t length);
    void binaryRequest(RibToken &);
    void definedString(RibToken &, int code);
    bool defineRequest(const SourceLocation &);
    bool defineString(const SourceLocation &, int code);
    bool definition(const SourceLocation &, std::string &text);
    void beginBinaryArray(RibToken &, int code);
    bool inBinaryArray(RibToken &);
    std::size_t floatsAtHand() const;
    void takeBinaryFloats(std::span<float>);
    bool take(std::size_t bytes, std::uint64_t &bigEndian);
    void bytes(std::uint64_t count, std::string &text);
    void truncated(const SourceLocation &);
    /// Once a file.
    void badBinary(const SourceLocation &, const std::string &message);

    std::unique_ptr<ByteSource> source_;
    std::shared_ptr<const std::string> file_;
    DiagnosticSink &diagnostics_;
    int line_ = 1;
    std::int64_t column_ = 1;
    bool strayReported_ = false, failureReported_ = false, binaryReported_ = false;
    bool silent_ = false, endsAtMark_ = false, ended_ = false;
    bool forgiven_[2] = {};
    bool keepsComments_ = false;
    std::vector<RibComment> comments_;

    std::array<std::string, 256> requests_; ///< By their codes; empty: not defined.
    std::unordered_map<std::uint32_t, std::string> strings_;
    std::uint64_t stringBytes_ = 0; ///< Of references to strings so far.
    std::uint64_t arrayLeft_ = 0;   ///< Numbers of a binary array that come.
    bool inArray_ = false;          ///< Its end has not been told.
};

} // namespace candela
