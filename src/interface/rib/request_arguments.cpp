// SPDX-License-Identifier: Apache-2.0
// The arguments of requests, each read by its type.
#include "interface/rib/request_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {

static std::string describe(const RibToken &token) {
    switch (token.kind) {
    case TokenKind::Request: return "'" + token.text + "'";
    case TokenKind::Number: return "the number " + token.text;
    case TokenKind::String: return "the string \"" + token.text.substr(0, 40) + "\"";
    case TokenKind::ArrayBegin: return "'['";
    case TokenKind::ArrayEnd: return "']'";
    case TokenKind::End: return "the end of the file";
    }
    return {};
}

void RequestReader::error(const SourceLocation &where, const std::string &message) {
    reader_.diagnostics_.error(where, std::string(request_) + ": " + message);
}

std::string RequestReader::argument() const {
    if (argumentIndex_ < 0 || argumentIndex_ >= int(argumentNames_.size()))
        return {};
    return " for '" + std::string(argumentNames_[argumentIndex_]) + "' (argument " +
           std::to_string(argumentIndex_ + 1) + ")";
}

/// Reports that something else stands here; false, for the caller to return.
bool RequestReader::expected(const std::string &what) {
    error(token_.where, "expected " + what + argument() + ", found " + describe(token_) +
                            "; the request is left out");
    return false;
}

/// Brackets may stand around any run of arguments of fixed number: Sphere [1 -1 1 360].
void RequestReader::openBracket() {
    if (!inBracket_ && at(TokenKind::ArrayBegin)) {
        inBracket_ = true;
        next();
    }
}

void RequestReader::closeBracket() {
    if (inBracket_ && at(TokenKind::ArrayEnd)) {
        inBracket_ = false;
        next();
    }
}

bool RequestReader::argumentsEnd() {
    if (inBracket_) {
        argumentIndex_ = -1;
        return expected("']'");
    }
    if (atRequestOrEnd())
        return true;
    // A request that takes none, such as WorldBegin, is clear in spite of them.
    bool clear = argumentNames_.empty();
    error(token_.where, "expected the next request after " + std::to_string(argumentNames_.size()) +
                            " arguments, found " + describe(token_) +
                            (clear ? "" : "; the request is left out"));
    if (clear)
        skipToRequest();
    return clear;
}

bool RequestReader::numbers(std::span<float> values) {
    openBracket();
    for (float &value : values) {
        if (!at(TokenKind::Number))
            return expected("a number");
        value = float(token_.number);
        next();
    }
    closeBracket();
    return true;
}

bool RequestReader::integer(int &value) {
    double number = token_.number;
    if (!at(TokenKind::Number) || number != std::floor(number) ||
        std::fabs(number) > std::numeric_limits<int>::max())
        return expected("a whole number");
    value = int(number);
    next();
    return true;
}

bool RequestReader::read(float &value) {
    ++argumentIndex_;
    return numbers({&value, 1});
}

bool RequestReader::read(int &value) {
    ++argumentIndex_;
    openBracket();
    bool good = integer(value);
    closeBracket();
    return good;
}

bool RequestReader::read(bool &value) {
    int number = 0;
    bool good = read(number);
    value = number != 0;
    return good;
}

bool RequestReader::read(std::string &value) {
    ++argumentIndex_;
    openBracket();
    if (!at(TokenKind::String))
        return expected("a string");
    value = token_.text;
    next();
    closeBracket();
    return true;
}

bool RequestReader::read(Handle &handle) {
    ++argumentIndex_;
    bool whole = at(TokenKind::Number) && token_.whole;
    if (!whole && !at(TokenKind::String))
        return expected("a handle (a whole number or a string)");
    handle.text = token_.text;
    next();
    return true;
}

bool RequestReader::read(Color &color) {
    ++argumentIndex_;
    return numbers(color.c);
}

bool RequestReader::read(Matrix4 &matrix) {
    ++argumentIndex_;
    return numbers(matrix.m);
}

bool RequestReader::read(BasisArgument &basis) {
    ++argumentIndex_;
    if (at(TokenKind::String)) {
        basis = token_.text;
        next();
        return true;
    }
    return numbers(basis.emplace<std::array<float, 16>>());
}

bool RequestReader::read(LooseFloats &loose) {
    ++argumentIndex_;
    if (at(TokenKind::ArrayBegin)) {
        --argumentIndex_;
        return read(loose.values);
    }
    for (; at(TokenKind::Number); next())
        loose.values.push_back(float(token_.number));
    return true;
}

bool RequestReader::read(Floats &values) {
    ++argumentIndex_;
    bool array = at(TokenKind::ArrayBegin);
    if (array)
        next();
    for (; at(TokenKind::Number); next()) {
        values.push_back(float(token_.number));
        if (!array) {
            next();
            return true;
        }
    }
    if (!array)
        return expected("'[' and numbers");
    if (!at(TokenKind::ArrayEnd))
        return expected("a number or ']'");
    next();
    return true;
}

bool RequestReader::read(Integers &values) {
    ++argumentIndex_;
    if (!at(TokenKind::ArrayBegin))
        return at(TokenKind::Number) ? integer(values.emplace_back())
                                     : expected("'[' and whole numbers");
    for (next(); at(TokenKind::Number);)
        if (!integer(values.emplace_back()))
            return false;
    if (!at(TokenKind::ArrayEnd))
        return expected("a whole number or ']'");
    next();
    return true;
}

bool RequestReader::read(Strings &values) {
    ++argumentIndex_;
    bool array = at(TokenKind::ArrayBegin);
    if (array)
        next();
    for (; at(TokenKind::String); next()) {
        values.push_back(token_.text);
        if (!array) {
            next();
            return true;
        }
    }
    if (!array)
        return expected("'[' and strings");
    if (!at(TokenKind::ArrayEnd))
        return expected("a string or ']'");
    next();
    return true;
}

bool RequestReader::read(SubdivisionTags &tags) {
    int index = ++argumentIndex_;
    if (!at(TokenKind::ArrayBegin))
        return true;
    bool good =
        read(tags.names) && read(tags.argumentCounts) && read(tags.integers) && read(tags.floats);
    Strings furtherArguments; // RI 3.2.1
    if (good && at(TokenKind::ArrayBegin))
        good = read(furtherArguments);
    argumentIndex_ = index;
    return good;
}

/// Bad parameters are reported and left out; the request stands.
bool RequestReader::read(TokenList &list) {
    ++argumentIndex_;
    if (inBracket_) {
        argumentIndex_ = -1;
        return expected("']'");
    }
    if (!atRequestOrEnd() && !at(TokenKind::String))
        return expected("the name of a parameter");
    while (!atRequestOrEnd()) {
        if (at(TokenKind::String)) {
            if (auto value = tokenValue())
                list.all.push_back(std::move(*value));
            continue;
        }
        error(token_.where, "expected the name of a parameter, found " + describe(token_));
        while (!atRequestOrEnd() && !at(TokenKind::String))
            next();
    }
    return true;
}

std::optional<TokenValue> RequestReader::tokenValue() {
    TokenValue result{token_.text, token_.where, {}, {}};
    next();
    if (at(TokenKind::Number)) {
        result.floats.push_back(float(token_.number));
        next();
    } else if (at(TokenKind::String)) {
        result.strings.push_back(token_.text);
        next();
    } else if (at(TokenKind::ArrayBegin)) {
        if (!arrayValues(result))
            return std::nullopt;
    } else {
        error(result.where, "parameter '" + result.token + "' has no value: found " +
                                describe(token_) + "; the parameter is left out");
        return std::nullopt;
    }
    return result;
}

/// Numbers or strings in brackets; false, reported and passed, if they are anything else.
bool RequestReader::arrayValues(TokenValue &value) {
    next();
    for (; !at(TokenKind::ArrayEnd); next()) {
        if (at(TokenKind::Number) && value.strings.empty()) {
            value.floats.push_back(float(token_.number));
        } else if (at(TokenKind::String) && value.floats.empty()) {
            value.strings.push_back(token_.text);
        } else {
            bool mixed = at(TokenKind::Number) || at(TokenKind::String);
            error(token_.where,
                  "parameter '" + value.token + "': " +
                      (mixed ? "numbers and strings are mixed, found " : "expected ']', found ") +
                      describe(token_) + "; the parameter is left out");
            skipArray();
            return false;
        }
    }
    next();
    return true;
}

void RequestReader::skipArray() {
    int depth = 1;
    for (; depth > 0 && !atRequestOrEnd(); next())
        depth += at(TokenKind::ArrayBegin) ? 1 : at(TokenKind::ArrayEnd) ? -1 : 0;
}

} // namespace candela
