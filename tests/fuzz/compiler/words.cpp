// SPDX-License-Identifier: Apache-2.0
#include "words.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace candela::fuzz {

namespace {

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Where blanks and comments from `at` on end.
std::size_t endOfSpace(std::string_view text, std::size_t at) {
    while (at < text.size()) {
        if (std::isspace(static_cast<unsigned char>(text[at])))
            ++at;
        else if (text.substr(at, 2) == "/*")
            at = std::min(text.find("*/", at + 2), text.size() - 2) + 2;
        else if (text.substr(at, 2) == "//")
            at = std::min(text.find('\n', at), text.size());
        else
            break;
    }
    return at;
}

std::size_t endOfString(std::string_view text, std::size_t at) {
    for (++at; at < text.size() && text[at] != '"' && text[at] != '\n'; ++at)
        at += text[at] == '\\' && at + 1 < text.size();
    return std::min(at + 1, text.size());
}

std::size_t endOfNumber(std::string_view text, std::size_t at) {
    for (; at < text.size(); ++at) {
        const bool exponent = text[at - 1] == 'e' || text[at - 1] == 'E';
        const bool sign = exponent && (text[at] == '+' || text[at] == '-');
        if (!isDigit(text[at]) && !isLetter(text[at]) && text[at] != '.' && !sign)
            break;
    }
    return at;
}

std::size_t endOfWord(std::string_view text, std::size_t at) {
    const auto next = [&](std::size_t ahead) {
        return at + ahead < text.size() ? text[at + ahead] : '\0';
    };
    if (text[at] == '"')
        return endOfString(text, at);
    if (isDigit(text[at]) || (text[at] == '.' && isDigit(next(1))))
        return endOfNumber(text, at + 1);
    if (isLetter(text[at])) {
        while (at < text.size() && (isLetter(text[at]) || isDigit(text[at])))
            ++at;
        return at;
    }
    static constexpr std::array pairs{
        "+=", "-=", "*=", "/=", "==", "!=", "<=", ">=", "&&", "||", "##", "::", "->"};
    const std::string_view two = text.substr(at, 2);
    return at + (std::ranges::find(pairs, two) != pairs.end() ? 2 : 1);
}

bool opens(const Word &word) { return word.text == "(" || word.text == "[" || word.text == "{"; }
bool closes(const Word &word) { return word.text == ")" || word.text == "]" || word.text == "}"; }

} // namespace

Words wordsOf(std::string_view text) {
    Words words;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t begin = endOfSpace(text, at);
        const std::size_t end = begin < text.size() ? endOfWord(text, begin) : begin;
        words.push_back({std::string(text.substr(at, begin - at)),
                         std::string(text.substr(begin, end - begin))});
        at = end;
    }
    return words;
}

std::string textOf(const Words &words) {
    std::string text;
    for (const Word &word : words)
        text += word.space + word.text;
    return text;
}

bool isNumber(const Word &word) {
    return !word.text.empty() &&
           (isDigit(word.text[0]) || (word.text.size() > 1 && word.text[0] == '.'));
}
bool isName(const Word &word) { return !word.text.empty() && isLetter(word.text[0]); }
bool isString(const Word &word) { return !word.text.empty() && word.text[0] == '"'; }

bool startsLine(const Words &words, std::size_t at) {
    return at == 0 || words[at].space.find('\n') != std::string::npos;
}

Words copyOf(const Words &words, Span span) {
    return {words.begin() + std::ptrdiff_t(span.begin), words.begin() + std::ptrdiff_t(span.end)};
}

void replace(Words &words, Span span, const Words &piece) {
    const auto from = words.begin() + std::ptrdiff_t(span.begin);
    const auto at = words.erase(from, from + std::ptrdiff_t(span.end - span.begin));
    words.insert(at, piece.begin(), piece.end());
}

std::vector<Span> groupsOf(const Words &words) {
    std::vector<Span> groups;
    std::vector<std::size_t> open; // Into groups.
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (opens(words[i])) {
            open.push_back(groups.size());
            groups.push_back({i, words.size()});
        } else if (closes(words[i]) && !open.empty()) {
            groups[open.back()].end = i + 1;
            open.pop_back();
        }
    }
    return groups;
}

std::vector<Span> argumentsOf(const Words &words) {
    std::vector<Span> arguments;
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool comma = words[i].text == ",";
        if ((comma || closes(words[i])) && !begins.empty()) {
            if (begins.back() < i)
                arguments.push_back({begins.back(), i});
            begins.pop_back();
        }
        if (comma || opens(words[i]))
            begins.push_back(i + 1);
    }
    return arguments;
}

std::vector<Span> statementsOf(const Words &words) {
    std::vector<Span> statements;
    std::size_t begin = 0;
    int depth = 0; // Of ( ) and [ ].
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string &text = words[i].text;
        depth += text == "(" || text == "[";
        depth = std::max(0, depth - (text == ")" || text == "]"));
        const bool brace = text == "{" || text == "}";
        if (!brace && (text != ";" || depth > 0))
            continue;
        if (text == ";" && begin < i)
            statements.push_back({begin, i + 1});
        begin = i + 1;
        depth = brace ? 0 : depth;
    }
    for (const Span &group : groupsOf(words))
        if (words[group.begin].text == "{")
            statements.push_back(group);
    return statements;
}

std::vector<Span> linesOf(const Words &words) {
    std::vector<Span> lines;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (startsLine(words, i))
            lines.push_back({i, i});
        lines.back().end = i + 1;
    }
    return lines;
}

} // namespace candela::fuzz
