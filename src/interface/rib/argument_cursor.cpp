// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/argument_cursor.h"

#include "interface/rib/request_names.h"

#include <array>
#include <charconv>

namespace candela {

static std::string numberText(double number) {
    std::array<char, 32> digits;
    return {digits.data(), std::to_chars(digits.begin(), digits.end(), number).ptr};
}

std::string describe(const RibToken &token) {
    switch (token.kind) {
    case TokenKind::Request: return "'" + token.text + "'";
    case TokenKind::Number: return "the number " + numberText(token.number);
    case TokenKind::String: return "the string \"" + token.text.substr(0, 40) + "\"";
    case TokenKind::ArrayBegin: return "'['";
    case TokenKind::ArrayEnd: return "']'";
    case TokenKind::End: return "the end of the file";
    }
    return {};
}

void ArgumentCursor::begin(const RequestDescription &request) {
    request_ = &request;
    argument_ = -1;
    inBracket_ = false;
    next();
}

void ArgumentCursor::openBracket() {
    if (!inBracket_ && at(TokenKind::ArrayBegin)) {
        inBracket_ = true;
        next();
    }
}

void ArgumentCursor::closeBracket() {
    if (inBracket_ && at(TokenKind::ArrayEnd)) {
        inBracket_ = false;
        next();
    }
}

bool ArgumentCursor::bracketsClosed() {
    if (!inBracket_)
        return true;
    argument_ = -1;
    return expected("']'");
}

bool ArgumentCursor::atEndOfArguments() {
    if (!bracketsClosed())
        return false;
    if (atRequestOrEnd())
        return true;
    // A request that takes none, such as WorldBegin, is clear in spite of them.
    const auto count = request_->argumentNames.size();
    bool clear = count == 0;
    error(token_.where, "expected the next request after " + std::to_string(count) +
                            " arguments, found " + describe(token_) +
                            (clear ? "" : "; the request is left out"));
    if (clear)
        skipToRequest();
    return clear;
}

void ArgumentCursor::skipToRequest() {
    while (!at(TokenKind::End) && !(at(TokenKind::Request) && requestNamed(token_.text)))
        next();
}

bool ArgumentCursor::expected(const std::string &what) {
    std::string argument;
    if (argument_ >= 0 && argument_ < int(request_->argumentNames.size()))
        argument = " for '" + std::string(request_->argumentNames[argument_]) + "' (argument " +
                   std::to_string(argument_ + 1) + ")";
    const bool follows = argument_ > 0 && argument_ < int(request_->argumentNames.size());
    const bool lacksHandle = follows && request_->argumentNames[argument_ - 1] == "handle" &&
                             !at(TokenKind::String) && !atRequestOrEnd();
    error(token_.where, "expected " + what + argument + ", found " + describe(token_) +
                            (lacksHandle ? " (is the handle before the parameters missing?)" : "") +
                            "; the request is left out");
    return false;
}

void ArgumentCursor::error(const SourceLocation &where, const std::string &message) {
    diagnostics_.error(where, std::string(request_->name) + ": " + message);
}

} // namespace candela
