// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/arguments.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>

namespace candela {

// The value of the token that stands here.
static bool valueHere(ArgumentCursor &cursor, float &value) {
    if (!cursor.at(TokenKind::Number))
        return cursor.expected("a number");
    value = cursor.token().single;
    return true;
}

static bool valueHere(ArgumentCursor &cursor, int &value) {
    double number = cursor.token().number;
    if (!cursor.at(TokenKind::Number) || number != std::floor(number) ||
        std::fabs(number) > std::numeric_limits<int>::max())
        return cursor.expected("a whole number");
    value = int(number);
    return true;
}

static bool valueHere(ArgumentCursor &cursor, std::string &value) {
    if (!cursor.at(TokenKind::String))
        return cursor.expected("a string");
    value = cursor.token().text;
    return true;
}

template <class Value> static bool take(ArgumentCursor &cursor, Value &value) {
    if (!valueHere(cursor, value))
        return false;
    cursor.next();
    return true;
}

/// The next token of an array.
template <class Value> static void nextOf(ArgumentCursor &cursor, std::vector<Value> &values) {
    cursor.nextNumbers(values);
}
static void nextOf(ArgumentCursor &cursor, Strings &) { cursor.next(); }

/// Arguments of fixed number.
template <class Values> static bool takeAll(ArgumentCursor &cursor, Values &&values) {
    cursor.openBracket();
    for (auto &value : values)
        if (!take(cursor, value))
            return false;
    cursor.closeBracket();
    return true;
}

static bool takeAll(ArgumentCursor &cursor, std::span<float> values) {
    cursor.openBracket();
    for (std::size_t i = 0; i < values.size();) {
        if (!cursor.at(TokenKind::Number) && values.size() > 1)
            return cursor.expected(std::to_string(values.size()) + " numbers, not " +
                                   std::to_string(i) + ",");
        if (!valueHere(cursor, values[i]))
            return false;
        ++i;
        i += cursor.nextNumbers(values.subspan(i));
    }
    cursor.closeBracket();
    return true;
}

/// An array in brackets, or one value without them. `several` and `one` name what it holds.
template <class Value>
static bool takeArray(ArgumentCursor &cursor, std::vector<Value> &values, TokenKind kind,
                      const char *several, const char *one) {
    bool array = cursor.at(TokenKind::ArrayBegin);
    if (!array && !cursor.at(kind))
        return cursor.expected(std::string("'[' and ") + several);
    if (!array)
        return take(cursor, values.emplace_back());
    for (nextOf(cursor, values); cursor.at(kind); nextOf(cursor, values))
        if (!valueHere(cursor, values.emplace_back()))
            return false;
    if (!cursor.at(TokenKind::ArrayEnd))
        return cursor.expected(std::string(one) + " or ']'");
    cursor.next();
    return true;
}

bool read(ArgumentCursor &cursor, float &value) { return takeAll(cursor, std::span(&value, 1)); }
bool read(ArgumentCursor &cursor, int &value) { return takeAll(cursor, std::span(&value, 1)); }

bool read(ArgumentCursor &cursor, bool &value) {
    int number = 0;
    bool good = read(cursor, number);
    value = number != 0;
    return good;
}

bool read(ArgumentCursor &cursor, std::string &value) {
    return takeAll(cursor, std::span(&value, 1));
}

static std::string wholeText(double number) {
    std::array<char, 512> digits;
    return {digits.data(),
            std::to_chars(digits.begin(), digits.end(), number, std::chars_format::fixed).ptr};
}

bool read(ArgumentCursor &cursor, Handle &handle) {
    bool whole = cursor.at(TokenKind::Number) && cursor.token().whole;
    if (!whole && !cursor.at(TokenKind::String))
        return cursor.expected("a handle (a whole number or a string)");
    handle.text = whole ? wholeText(cursor.token().number) : cursor.token().text;
    cursor.next();
    return true;
}

bool read(ArgumentCursor &cursor, Color &color) {
    return takeAll(cursor, std::span<float>(color.c));
}
bool read(ArgumentCursor &cursor, Matrix4 &matrix) {
    return takeAll(cursor, std::span<float>(matrix.m));
}

bool read(ArgumentCursor &cursor, BasisArgument &basis) {
    if (cursor.at(TokenKind::String))
        return take(cursor, basis.emplace<std::string>());
    return takeAll(cursor, std::span<float>(basis.emplace<std::array<float, 16>>()));
}

bool read(ArgumentCursor &cursor, Floats &values) {
    return takeArray(cursor, values, TokenKind::Number, "numbers", "a number");
}

bool read(ArgumentCursor &cursor, Integers &values) {
    return takeArray(cursor, values, TokenKind::Number, "whole numbers", "a whole number");
}

bool read(ArgumentCursor &cursor, Strings &values) {
    return takeArray(cursor, values, TokenKind::String, "strings", "a string");
}

bool read(ArgumentCursor &cursor, LooseFloats &loose) {
    if (cursor.at(TokenKind::ArrayBegin))
        return read(cursor, loose.values);
    while (cursor.at(TokenKind::Number))
        take(cursor, loose.values.emplace_back());
    return true;
}

bool read(ArgumentCursor &cursor, SubdivisionTags &tags) {
    if (!cursor.at(TokenKind::ArrayBegin))
        return true;
    int index = cursor.argument();
    bool good = readNext(cursor, tags.names) && readNext(cursor, tags.argumentCounts) &&
                readNext(cursor, tags.integers) && readNext(cursor, tags.floats);
    Strings furtherArguments; // RI 3.2.1
    if (good && cursor.at(TokenKind::ArrayBegin))
        good = readNext(cursor, furtherArguments);
    cursor.setArgument(index);
    return good;
}

} // namespace candela
