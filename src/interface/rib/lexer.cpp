// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/lexer.h"

#include "interface/rib/request_names.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

namespace candela {

namespace {

bool isDigit(int c) { return c >= '0' && c <= '9'; }
bool isLetter(int c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isBlank(int c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool isWordPart(int c) { return isLetter(c) || isDigit(c); }
/// No part of RIB; some programs write them between numbers or behind requests.
bool isSeparator(int c) { return c == ',' || c == ';'; }
/// Ends a word or number.
bool isDelimiter(int c) {
    return c < 0 || isBlank(c) || c == '[' || c == ']' || c == '"' || c == '#';
}

/// "nan", "inf" and "infinity", which programs print for numbers that are none.
std::optional<double> specialNumber(std::string text) {
    double sign = 1;
    if (text.starts_with('-') || text.starts_with('+')) {
        sign = text.front() == '-' ? -1 : 1;
        text.erase(0, 1);
    }
    std::ranges::transform(text, text.begin(), [](char c) { return char(std::tolower(c)); });
    if (text == "nan")
        return std::numeric_limits<double>::quiet_NaN();
    if (text == "inf" || text == "infinity")
        return sign * std::numeric_limits<double>::infinity();
    return std::nullopt;
}

std::optional<double> parseNumber(const std::string &text) {
    const char *begin = text.data() + text.starts_with('+'), *end = text.data() + text.size();
    double value = 0;
    auto [stop, error] = std::from_chars(begin, end, value);
    if (stop != end || begin == end || (text.starts_with('+') && *begin == '-'))
        return specialNumber(text);
    if (error == std::errc::result_out_of_range)
        return std::strtod(text.c_str(), nullptr); // Infinity or zero, as it may be.
    return error == std::errc() ? std::optional(value) : std::nullopt;
}

} // namespace

Lexer::Lexer(std::unique_ptr<ByteSource> source, std::string file, DiagnosticSink &diagnostics)
    : source_(std::move(source)), file_(std::make_shared<const std::string>(std::move(file))),
      diagnostics_(diagnostics) {
    // Editors of other systems begin UTF-8 with a byte order mark.
    if (peek(0) == 0xEF && peek(1) == 0xBB && peek(2) == 0xBF)
        for (int i = 0; i < 3; ++i)
            source_->skip();
}

void Lexer::error(const SourceLocation &where, const std::string &message) {
    if (!silent_)
        diagnostics_.error(where, message);
}

void Lexer::forgive(Slip slip, const SourceLocation &where, const std::string &message) {
    if (!silent_ && !std::exchange(forgiven_[int(slip)], true))
        diagnostics_.warning(where, message);
}

/// One byte on; CRLF counts when its LF is passed.
void Lexer::advance() {
    int c = peek();
    source_->skip();
    if (c == '\n' || (c == '\r' && peek() != '\n')) {
        ++line_;
        column_ = 1;
    } else {
        ++column_;
    }
}

void Lexer::skipBlanks() {
    for (int c = peek(); isBlank(c) || c == '#'; c = peek()) {
        if (c == '#')
            while (peek() >= 0 && peek() != '\n' && peek() != '\r')
                advance();
        else
            advance();
    }
}

bool Lexer::atNumber() {
    int c = peek();
    if (c == '+' || c == '-')
        return !isDelimiter(peek(1));
    return isDigit(c) || c == '.';
}

RibToken Lexer::next() {
    for (;;) {
        skipBlanks();
        RibToken token;
        token.where = {file_, line_, column_};
        int c = peek();
        if (c < 0) {
            if (!source_->failure().empty() && !std::exchange(failureReported_, true))
                diagnostics_.error(token.where,
                                   "the file cannot be read further: " + source_->failure());
            return token;
        }
        if (c == '[' || c == ']') {
            advance();
            token.kind = c == '[' ? TokenKind::ArrayBegin : TokenKind::ArrayEnd;
            return token;
        }
        if (c == '"')
            return string(std::move(token));
        if (c == '\'') {
            forgive(Slip::Quotes, token.where,
                    "strings stand in \"double quotes\"; those in 'single "
                    "ones' are taken for strings, too");
            return string(std::move(token));
        }
        if (atNumber()) {
            return number(std::move(token));
        } else if (isLetter(c)) {
            return request(std::move(token));
        } else if (isSeparator(c)) {
            forgive(Slip::Separators, token.where,
                    "',' and ';' separate nothing in RIB; they are "
                    "taken for blanks");
            advance();
        } else {
            skipStrayBytes(token.where);
        }
    }
}

void Lexer::skipStrayBytes(const SourceLocation &where) {
    bool binary = peek() >= 0200;
    std::string bytes;
    do {
        if (bytes.size() < 20)
            bytes += char(peek());
        advance();
    } while (peek() >= 0 && !isDelimiter(peek()) && !isWordPart(peek()));
    // Once a file: a file that is no RIB at all would say little else.
    if (silent_ || std::exchange(strayReported_[binary], true))
        return;
    error(where, binary ? "bytes above 127 outside strings and comments are binary "
                          "RIB, which this version does not read; they are skipped"
                        : "'" + bytes + "' is no part of RIB; it is skipped");
}

/// A word: the name of a request, or a number that is none.
RibToken Lexer::request(RibToken token) {
    while (isWordPart(peek())) {
        token.text += char(peek());
        advance();
    }
    token.kind = TokenKind::Request;
    if (auto special = specialNumber(token.text)) {
        token.kind = TokenKind::Number;
        token.number = *special;
    }
    return token;
}

/// What begins as a number and is none is reported and counts as not-a-number: something stands
/// there, so the count of values stays as the user sees it.
RibToken Lexer::number(RibToken token) {
    token.kind = TokenKind::Number;
    // A comma within a number may be meant for its point.
    while (!isDelimiter(peek()) && !(isSeparator(peek()) && !isDigit(peek(1)))) {
        token.text += char(peek());
        advance();
    }
    if (auto value = parseNumber(token.text)) {
        token.number = *value;
        token.whole = token.text.find_first_not_of("+-0123456789") == std::string::npos;
    } else {
        error(token.where, "'" + token.text.substr(0, 40) + "' is no number");
        token.number = std::numeric_limits<double>::quiet_NaN();
    }
    return token;
}

/// A string may hold line ends. One that is followed by a line beginning with a request has lost
/// its closing quote.
bool Lexer::requestFollowsLineEnd() {
    std::size_t at = 0;
    while (at < 100 && isBlank(peek(at)))
        ++at;
    std::string word;
    while (word.size() < 40 && isWordPart(peek(at + word.size())))
        word += char(peek(at + word.size()));
    int after = peek(at + word.size());
    return requestNamed(word) && (isBlank(after) || after < 0);
}

RibToken Lexer::string(RibToken token) {
    token.kind = TokenKind::String;
    const int quote = peek();
    advance();
    for (int c = peek(); c != quote; c = peek()) {
        bool lineEnd = c == '\n' || c == '\r';
        if (c < 0 || (lineEnd && requestFollowsLineEnd())) {
            error(token.where, "unterminated string: expected a closing quote before the end of "
                               "the " +
                                   std::string(c < 0 ? "file" : "line"));
            return token;
        }
        if (c == '\\') {
            escape(token.text);
            continue;
        }
        if (!(c == '\r' && peek(1) == '\n'))
            token.text += lineEnd ? '\n' : char(c);
        advance();
    }
    advance();
    return token;
}

/// After a backslash: a control character, an octal code, or a line end that is not there.
void Lexer::escape(std::string &text) {
    advance();
    int c = peek();
    if (c < 0)
        return;
    if (c >= '0' && c <= '7') {
        int code = 0;
        for (int digits = 0; digits < 3 && peek() >= '0' && peek() <= '7'; ++digits) {
            code = code * 8 + (peek() - '0');
            advance();
        }
        text += char(code & 0377);
        return;
    }
    bool crlf = c == '\r' && peek(1) == '\n';
    advance();
    switch (c) {
    case 'n': text += '\n'; break;
    case 'r': text += '\r'; break;
    case 't': text += '\t'; break;
    case 'b': text += '\b'; break;
    case 'f': text += '\f'; break;
    case '\n': break;
    case '\r':
        if (crlf)
            advance();
        break;
    default: text += char(c);
    }
}

} // namespace candela
