// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/lexer.h"

#include "interface/ri/wide_integers.h"
#include "interface/rib/number_text.h"
#include "interface/rib/request_names.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace candela {

namespace {

bool isDigit(int c) { return c >= '0' && c <= '9'; }
bool isLetter(int c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
/// DOS ended files with Ctrl-Z.
bool isBlank(int c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\x1a';
}
bool isWordPart(int c) { return isLetter(c) || isDigit(c); }
/// No part of RIB; some programs write them between numbers or behind requests.
bool isSeparator(int c) { return c == ',' || c == ';'; }
/// Ends a word or number.
bool isDelimiter(int c) {
    return c < 0 || isBlank(c) || c == '[' || c == ']' || c == '"' || c == '#' || c >= 0200;
}

} // namespace

Lexer::Lexer(std::unique_ptr<ByteSource> source, std::string file, DiagnosticSink &diagnostics)
    : source_(std::move(source)), file_(std::make_shared<const std::string>(std::move(file))),
      diagnostics_(diagnostics) {
    // Editors of other systems begin UTF-8 with a byte order mark.
    if (peek(0) == 0xEF && peek(1) == 0xBB && peek(2) == 0xBF)
        source_->skip(3);
}

void Lexer::error(const SourceLocation &where, const std::string &message) {
    if (!silent_)
        diagnostics_.error(where, message);
}

void Lexer::forgive(Slip slip, const SourceLocation &where, const std::string &message) {
    if (!silent_ && !std::exchange(forgiven_[int(slip)], true))
        diagnostics_.warning(where, message);
}

/// Binary files may be one long line.
int Lexer::column() const {
    return int(std::min<std::int64_t>(column_, std::numeric_limits<int>::max()));
}

SourceLocation Lexer::here() const { return {file_, line_, column()}; }

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

void Lexer::skip(std::size_t count) {
    source_->skip(count);
    column_ += std::int64_t(count);
}

void Lexer::skipBlanks() {
    for (int c = peek(); isBlank(c) || c == '#'; c = peek())
        if (c == '#')
            comment();
        else
            advance();
}

void Lexer::comment() {
    const SourceLocation where = keepsComments_ ? here() : SourceLocation{};
    std::string text;
    while (peek() >= 0 && peek() != '\n' && peek() != '\r') {
        const std::string_view window = source_->window();
        const std::size_t length = std::min(window.find_first_of("\n\r"), window.size());
        if (keepsComments_)
            text += window.substr(0, length);
        skip(length);
    }
    if (keepsComments_)
        comments_.push_back({where, text.substr(1)});
}

bool Lexer::atNumber() {
    int c = peek();
    if (c == '+' || c == '-')
        return !isDelimiter(peek(1));
    return isDigit(c) || c == '.';
}

void Lexer::next(RibToken &token) {
    while (!readToken(token)) {
    }
}

/// False if what stood here was none.
bool Lexer::readToken(RibToken &token) {
    if (inArray_)
        return inBinaryArray(token);
    if (!ended_)
        skipBlanks();
    if (!token.where.file)
        token.where.file = file_;
    token.where.line = line_, token.where.column = column();
    token.text.clear();
    const int c = ended_ ? -1 : peek();
    if (c < 0) {
        token.kind = TokenKind::End;
        end(token.where);
    } else if (c >= 0200) {
        return binary(token);
    } else if (c == '[' || c == ']') {
        skip(1);
        token.kind = c == '[' ? TokenKind::ArrayBegin : TokenKind::ArrayEnd;
    } else if (c == '"') {
        string(token);
    } else if (c == '\'') {
        forgive(Slip::Quotes, token.where,
                "strings stand in \"double quotes\"; those in 'single ones' are taken for strings, "
                "too");
        string(token);
    } else if (atNumber()) {
        number(token);
    } else if (isLetter(c)) {
        request(token);
    } else if (isSeparator(c)) {
        forgive(Slip::Separators, token.where,
                "',' and ';' separate nothing in RIB; they are taken for blanks");
        skip(1);
        return false;
    } else {
        skipStrayBytes(token.where);
        return false;
    }
    return true;
}

void Lexer::end(const SourceLocation &where) {
    if (!source_->failure().empty() && !std::exchange(failureReported_, true))
        error(where, "the file cannot be read further: " + source_->failure());
}

void Lexer::skipStrayBytes(const SourceLocation &where) {
    std::string bytes;
    do {
        if (bytes.size() < 20)
            bytes += char(peek());
        advance();
    } while (peek() >= 0 && !isDelimiter(peek()) && !isWordPart(peek()));
    // Once a file: a file that is no RIB at all would say little else.
    if (!silent_ && !std::exchange(strayReported_, true))
        error(where, "'" + bytes + "' is no part of RIB; it is skipped");
}

/// A word: the name of a request, or a number that is none.
void Lexer::request(RibToken &token) {
    while (isWordPart(peek())) {
        const std::string_view window = source_->window();
        std::size_t length = 1;
        while (length < window.size() && isWordPart((unsigned char)window[length]))
            ++length;
        token.text += window.substr(0, length);
        skip(length);
    }
    token.kind = TokenKind::Request;
    constexpr std::size_t longest = std::string_view("infinity").size();
    const auto special =
        token.text.size() <= longest ? parseNumber(token.text) : std::optional<TextNumber>();
    if (special) {
        token.kind = TokenKind::Number;
        token.number = special->value, token.single = special->single;
        token.whole = false;
    }
}

/// What begins as a number and is none is reported and counts as not-a-number: something stands
/// there, so the count of values stays as the user sees it.
void Lexer::number(RibToken &token) {
    token.kind = TokenKind::Number;
    const std::string_view window = source_->window();
    TextNumber plain;
    const char *stop = parsePlainNumber(window.data(), window.data() + window.size(), plain);
    if (stop && isDelimiter((unsigned char)*stop)) {
        token.number = plain.value, token.single = plain.single, token.whole = plain.whole;
        return skip(std::size_t(stop - window.data()));
    }
    // A comma within a number may be meant for its point.
    while (!isDelimiter(peek()) && !(isSeparator(peek()) && !isDigit(peek(1)))) {
        token.text += char(peek());
        skip(1);
    }
    if (const auto number = parseNumber(token.text)) {
        token.number = number->value, token.single = number->single;
        token.whole = number->whole;
    } else {
        error(token.where, "'" + token.text.substr(0, 40) + "' is no number");
        token.number = token.single = std::numeric_limits<float>::quiet_NaN();
        token.whole = false;
    }
}

namespace {

// Where numbers are taken to.
template <class Value> struct VectorRoom {
    std::vector<Value> &values;
    static bool isFull() { return false; }
    void put(double value) { values.push_back(Value(value)); }
    /// Integers that floats cannot hold are next()'s, for parameters to keep.
    static bool takes(const TextNumber &number) {
        if constexpr (std::is_same_v<Value, float>)
            return !number.whole || !isWideInteger(number.value);
        else
            return number.whole && std::fabs(number.value) <= std::numeric_limits<int>::max();
    }
};

struct SpanRoom {
    std::span<float> values;
    std::size_t count = 0;
    bool isFull() const { return count == values.size(); }
    void put(double value) { values[count++] = float(value); }
    static bool takes(const TextNumber &) { return true; }
};

/// Of integers in binary, whole ones: as parsePlainNumber() does.
const char *parseBinaryInteger(const char *begin, const char *end, TextNumber &number) {
    const int size = (*begin & 3) + 1;
    if (end - begin <= size)
        return nullptr;
    std::int32_t value = (signed char)begin[1];
    for (int i = 2; i <= size; ++i)
        value = std::int32_t(std::uint32_t(value) << 8 | (unsigned char)begin[i]);
    number = {double(value), float(value), true};
    return begin + size + 1;
}

} // namespace

template <class Room> void Lexer::takePlainNumbers(Room &room) {
    const std::string_view window = source_->window();
    const char *const begin = window.data(), *const end = begin + window.size();
    const char *at = begin;
    std::int64_t lineStart = 1 - column_; // From the window's beginning.
    while (!room.isFull()) {
        const char *word = at;
        int line = line_;
        std::int64_t start = lineStart;
        for (; word != end && (*word == ' ' || *word == '\n' || *word == '\t'); ++word)
            if (*word == '\n')
                ++line, start = word + 1 - begin;
        TextNumber number;
        const bool binary = word != end && ((unsigned char)*word & 0374) == 0200;
        const char *stop =
            binary ? parseBinaryInteger(word, end, number) : parsePlainNumber(word, end, number);
        if (!stop || !(binary || isDelimiter((unsigned char)*stop)) || !Room::takes(number))
            break;
        room.put(number.value);
        at = stop, line_ = line, lineStart = start;
    }
    column_ = at - begin - lineStart + 1;
    source_->skip(std::size_t(at - begin));
}

void Lexer::takeNumbers(std::vector<float> &values) {
    VectorRoom<float> room{values};
    if (!inArray_)
        return takePlainNumbers(room);
    const std::size_t old = values.size();
    values.resize(old + floatsAtHand());
    takeBinaryFloats(std::span(values).subspan(old));
}

void Lexer::takeNumbers(std::vector<int> &values) {
    VectorRoom<int> room{values};
    if (!inArray_)
        takePlainNumbers(room);
}

std::size_t Lexer::takeNumbers(std::span<float> values) {
    SpanRoom room{values};
    if (!inArray_) {
        takePlainNumbers(room);
        return room.count;
    }
    values = values.first(std::min(values.size(), floatsAtHand()));
    takeBinaryFloats(values);
    return values.size();
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

void Lexer::string(RibToken &token) {
    token.kind = TokenKind::String;
    const int quote = peek();
    skip(1);
    const char special[] = {char(quote), '\\', '\n', '\r', 0};
    for (int c = peek(); c != quote; c = peek()) {
        const std::string_view window = source_->window();
        if (const std::size_t plain = std::min(window.find_first_of(special), window.size())) {
            token.text += window.substr(0, plain);
            skip(plain);
            continue;
        }
        bool lineEnd = c == '\n' || c == '\r';
        if (c < 0 || (lineEnd && requestFollowsLineEnd()))
            return error(token.where,
                         "unterminated string: expected a closing quote before the end "
                         "of the " +
                             std::string(c < 0 ? "file" : "line"));
        if (c == '\\') {
            escape(token.text);
            continue;
        }
        if (!(c == '\r' && peek(1) == '\n'))
            token.text += lineEnd ? '\n' : char(c);
        advance();
    }
    skip(1);
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
