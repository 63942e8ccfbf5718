// SPDX-License-Identifier: Apache-2.0
// Parameter lists: names with their values, not yet checked against declarations.
#include "interface/ri/wide_integers.h"
#include "interface/rib/arguments.h"

#include <cmath>
#include <optional>

namespace candela {

namespace {

/// What floats cannot hold of a parameter's numbers.
class WideIntegers {
public:
    void note(const RibToken &number, std::size_t place) {
        if (number.whole && isWideInteger(number.number))
            found_.emplace_back(place, int(number.number));
    }
    /// All numbers as integers, if there is something to keep and they can be.
    Integers among(const Floats &floats) const {
        if (found_.empty())
            return {};
        Integers all(floats.size());
        auto wide = found_.begin();
        for (std::size_t i = 0; i < floats.size(); ++i) {
            const bool isWide = wide != found_.end() && wide->first == i;
            if (!isWide && !isPlainInteger(floats[i]))
                return {};
            all[i] = isWide ? (wide++)->second : int(floats[i]);
        }
        return all;
    }

private:
    static bool isPlainInteger(float value) {
        constexpr float beyondInts = 2147483648.0f;
        return value >= -beyondInts && value < beyondInts && value == std::floor(value) &&
               !(value == 0 && std::signbit(value));
    }

    std::vector<std::pair<std::size_t, int>> found_; ///< By their places.
};

} // namespace

/// The rest of an array whose '[' is passed, with what is nested in it.
static void skipArray(ArgumentCursor &cursor) {
    int depth = 1;
    for (; depth > 0 && !cursor.atRequestOrEnd(); cursor.next())
        depth += cursor.at(TokenKind::ArrayBegin) ? 1 : cursor.at(TokenKind::ArrayEnd) ? -1 : 0;
}

/// Numbers or strings in brackets; false, reported and passed, if they are anything else.
static bool readValues(ArgumentCursor &cursor, TokenValue &value) {
    WideIntegers wide;
    cursor.nextNumbers(value.floats);
    while (!cursor.at(TokenKind::ArrayEnd)) {
        const RibToken &token = cursor.token();
        if (cursor.at(TokenKind::Number) && value.strings.empty()) {
            wide.note(token, value.floats.size());
            value.floats.push_back(token.single);
            cursor.nextNumbers(value.floats);
        } else if (cursor.at(TokenKind::String) && value.floats.empty()) {
            value.strings.push_back(token.text);
            cursor.next();
        } else {
            bool mixed = cursor.at(TokenKind::Number) || cursor.at(TokenKind::String);
            cursor.error(token.where, "parameter '" + value.token + "': " +
                                          (mixed ? "numbers and strings are mixed, found "
                                                 : "expected ']', found ") +
                                          describe(token) + "; the parameter is left out");
            skipArray(cursor);
            return false;
        }
    }
    value.integers = wide.among(value.floats);
    cursor.next();
    return true;
}

/// A name and its value; nothing, reported and passed, if there is none.
static std::optional<TokenValue> readParameter(ArgumentCursor &cursor) {
    const RibToken &token = cursor.token();
    TokenValue result;
    result.token = token.text, result.where = token.where;
    cursor.next();
    if (cursor.at(TokenKind::ArrayBegin))
        return readValues(cursor, result) ? std::optional(std::move(result)) : std::nullopt;
    if (cursor.at(TokenKind::Number)) {
        WideIntegers wide;
        wide.note(token, 0);
        result.floats.push_back(token.single);
        result.integers = wide.among(result.floats);
    } else if (cursor.at(TokenKind::String)) {
        result.strings.push_back(token.text);
    } else {
        cursor.error(result.where, "parameter '" + result.token + "' has no value: found " +
                                       describe(token) + "; the parameter is left out");
        return std::nullopt;
    }
    cursor.next();
    return result;
}

bool read(ArgumentCursor &cursor, TokenList &list) {
    if (!cursor.bracketsClosed())
        return false;
    if (!cursor.atRequestOrEnd() && !cursor.at(TokenKind::String))
        return cursor.expected("the name of a parameter");
    while (!cursor.atRequestOrEnd()) {
        if (cursor.at(TokenKind::String)) {
            if (auto parameter = readParameter(cursor))
                list.all.push_back(std::move(*parameter));
            continue;
        }
        cursor.error(cursor.token().where,
                     "expected the name of a parameter, found " + describe(cursor.token()));
        while (!cursor.atRequestOrEnd() && !cursor.at(TokenKind::String))
            cursor.next();
    }
    return true;
}

} // namespace candela
