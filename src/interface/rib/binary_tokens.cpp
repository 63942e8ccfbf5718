// SPDX-License-Identifier: Apache-2.0
// Binary RIB (RI 3.2, appendix C.2): what bytes of 0200 and more begin.
//
//     0200 + 4 d + w   number: w + 1 bytes, the last d of them behind the point
//     0220 + n         string of n bytes, n < 16
//     0240 + l         string, its length in l + 1 bytes
//     0244, 0245       float of 32 or 64 bits
//     0246 c           the request of code c
//     0310 + l         array of floats, their count in l + 1 bytes
//     0314 c string    code c means the request of that name
//     0315 + w         w + 1 bytes of a number, a string: the number means that string
//     0317 + w         w + 1 bytes: the string of that number
//     0377             the end of what a program answers
//
// All of several bytes begin with the highest.
#include "interface/rib/lexer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>
#include <utility>

namespace candela {

/// A longer one would be no name; references to long strings would fill memory from short files.
static constexpr std::size_t longestDefinedString = 1 << 16;

void Lexer::badBinary(const SourceLocation &where, const std::string &message) {
    if (!silent_ && !std::exchange(binaryReported_, true))
        diagnostics_.error(where, message);
}

void Lexer::truncated(const SourceLocation &where) {
    badBinary(where, "the file ends within something binary");
}

/// False at the end of the file, which is reported.
bool Lexer::take(std::size_t bytes, std::uint64_t &bigEndian) {
    bigEndian = 0;
    if (const std::string_view window = source_->window(); window.size() >= bytes) {
        for (const char byte : window.substr(0, bytes))
            bigEndian = bigEndian << 8 | (unsigned char)byte;
        skip(bytes);
        return true;
    }
    for (std::size_t i = 0; i < bytes; ++i) {
        const int byte = peek();
        if (byte < 0) {
            truncated(here());
            return false;
        }
        bigEndian = bigEndian << 8 | std::uint64_t(byte);
        skip(1);
    }
    return true;
}

void Lexer::bytes(std::uint64_t count, std::string &text) {
    while (count > 0 && peek() >= 0) {
        const std::string_view window = source_->window();
        const std::size_t some = std::size_t(std::min<std::uint64_t>(count, window.size()));
        text += window.substr(0, some);
        skip(some);
        count -= some;
    }
    if (count > 0)
        truncated(here());
}

/// False if it is no token.
bool Lexer::binary(RibToken &token) {
    const int code = peek();
    skip(1);
    std::uint64_t length = 0;
    if (code < 0220)
        binaryNumber(token, code);
    else if (code < 0240)
        binaryString(token, std::uint64_t(code - 0220));
    else if (code < 0244)
        binaryString(token, take(std::size_t(code - 0240 + 1), length) ? length : 0);
    else if (code <= 0245)
        binaryNumber(token, code);
    else if (code == 0246)
        binaryRequest(token);
    else if (code >= 0310 && code < 0314)
        beginBinaryArray(token, code);
    else if (code == 0314)
        return defineRequest(token.where);
    else if (code == 0315 || code == 0316)
        return defineString(token.where, code);
    else if (code == 0317 || code == 0320)
        definedString(token, code);
    else if (code == 0377) {
        ended_ = endsAtMark_;
        return false;
    } else {
        badBinary(token.where,
                  "the byte " + std::to_string(code) +
                      " begins nothing in binary RIB, and in ASCII RIB it may stand in "
                      "strings and comments alone; it is skipped");
        return false;
    }
    return true;
}

void Lexer::binaryNumber(RibToken &token, int code) {
    token.kind = TokenKind::Number;
    token.whole = code < 0204;
    token.number = binaryValue(code);
    token.single = float(token.number);
}

double Lexer::binaryValue(int code) {
    std::uint64_t bits = 0;
    if (code == 0245)
        return take(8, bits) ? std::bit_cast<double>(bits) : 0;
    if (code == 0244)
        return take(4, bits) ? double(std::bit_cast<float>(std::uint32_t(bits))) : 0;
    const int size = (code & 3) + 1, fraction = (code - 0200) >> 2, unused = 64 - 8 * size;
    take(std::size_t(size), bits);
    const double value = double(std::int64_t(bits << unused) >> unused);
    return fraction == 0 ? value : std::ldexp(value, -8 * fraction);
}

void Lexer::binaryString(RibToken &token, std::uint64_t length) {
    token.kind = TokenKind::String;
    bytes(length, token.text);
}

void Lexer::binaryRequest(RibToken &token) {
    token.kind = TokenKind::Request;
    std::uint64_t code = 0;
    if (take(1, code))
        token.text = requests_[code];
    if (token.text.empty()) // There is none of such a name.
        token.text = "of code " + std::to_string(code);
}

/// The string of a definition, in either encoding; reported if there is none.
bool Lexer::definition(const SourceLocation &where, std::string &text) {
    RibToken token;
    const int code = peek();
    const bool isString = code == '"' || (code >= 0220 && code < 0244);
    if (isString)
        readToken(token);
    if (!isString || token.text.size() > longestDefinedString) {
        badBinary(where, "expected a string of at most " + std::to_string(longestDefinedString) +
                             " bytes in a binary definition");
        return false;
    }
    text = std::move(token.text);
    return true;
}

bool Lexer::defineRequest(const SourceLocation &where) {
    std::uint64_t code = 0;
    std::string name;
    if (take(1, code) && definition(where, name))
        requests_[code] = std::move(name);
    return false;
}

bool Lexer::defineString(const SourceLocation &where, int code) {
    std::uint64_t number = 0;
    std::string text;
    if (take(std::size_t(code - 0315 + 1), number) && definition(where, text))
        strings_[std::uint32_t(number)] = std::move(text);
    return false;
}

void Lexer::definedString(RibToken &token, int code) {
    token.kind = TokenKind::String;
    std::uint64_t number = 0;
    if (!take(std::size_t(code - 0317 + 1), number))
        return;
    const auto found = strings_.find(std::uint32_t(number));
    if (found == strings_.end())
        return badBinary(token.where, "no string has the number " + std::to_string(number) +
                                          "; expected its definition before");
    // What files may make of their bytes by references is bounded.
    stringBytes_ += found->second.size();
    if (stringBytes_ > (std::uint64_t(64) << 20) + 32 * source_->position())
        return badBinary(token.where,
                         "strings that are named by number grow without bound; they are "
                         "left out from here on");
    token.text = found->second;
}

void Lexer::beginBinaryArray(RibToken &token, int code) {
    token.kind = TokenKind::ArrayBegin;
    if (!take(std::size_t(code - 0310 + 1), arrayLeft_))
        arrayLeft_ = 0;
    inArray_ = true;
}

/// One of the numbers, or behind them the array's end.
bool Lexer::inBinaryArray(RibToken &token) {
    token.where.line = line_, token.where.column = column();
    token.text.clear();
    if (arrayLeft_ > 0 && peek() < 0) {
        truncated(token.where);
        arrayLeft_ = 0;
    }
    if (arrayLeft_ == 0) {
        inArray_ = false;
        token.kind = TokenKind::ArrayEnd;
        return true;
    }
    --arrayLeft_;
    binaryNumber(token, 0244);
    return true;
}

/// Of the binary array; next() brings more.
std::size_t Lexer::floatsAtHand() const {
    return std::size_t(std::min<std::uint64_t>(arrayLeft_, source_->window().size() / 4));
}

void Lexer::takeBinaryFloats(std::span<float> values) {
    const auto *from = reinterpret_cast<const unsigned char *>(source_->window().data());
    for (float &value : values) {
        value = std::bit_cast<float>(std::uint32_t(from[0]) << 24 | std::uint32_t(from[1]) << 16 |
                                     std::uint32_t(from[2]) << 8 | from[3]);
        from += 4;
    }
    skip(4 * values.size());
    arrayLeft_ -= values.size();
}

} // namespace candela
