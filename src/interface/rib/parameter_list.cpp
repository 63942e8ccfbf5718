// SPDX-License-Identifier: Apache-2.0
// Parameter lists: names with their values, not yet checked against declarations.
#include "interface/rib/arguments.h"

#include <optional>

namespace candela {

/// The rest of an array whose '[' is passed, with what is nested in it.
static void skipArray(ArgumentCursor &cursor) {
    int depth = 1;
    for (; depth > 0 && !cursor.atRequestOrEnd(); cursor.next())
        depth += cursor.at(TokenKind::ArrayBegin) ? 1 : cursor.at(TokenKind::ArrayEnd) ? -1 : 0;
}

/// Numbers or strings in brackets; false, reported and passed, if they are anything else.
static bool readValues(ArgumentCursor &cursor, TokenValue &value) {
    cursor.nextNumbers(value.floats);
    while (!cursor.at(TokenKind::ArrayEnd)) {
        const RibToken &token = cursor.token();
        if (cursor.at(TokenKind::Number) && value.strings.empty()) {
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
    cursor.next();
    return true;
}

/// A name and its value; nothing, reported and passed, if there is none.
static std::optional<TokenValue> readParameter(ArgumentCursor &cursor) {
    const RibToken &token = cursor.token();
    TokenValue result{token.text, token.where, {}, {}};
    cursor.next();
    if (cursor.at(TokenKind::ArrayBegin))
        return readValues(cursor, result) ? std::optional(std::move(result)) : std::nullopt;
    if (cursor.at(TokenKind::Number)) {
        result.floats.push_back(token.single);
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
