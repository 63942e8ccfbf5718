// SPDX-License-Identifier: Apache-2.0
#include "reduce.h"

#include <algorithm>

namespace candela::fuzz {

namespace {

using Fails = std::function<bool(const std::string &)>;

/// Removes what can be removed in pieces of so many words; true if anything could.
bool removePieces(Words &words, std::size_t length, const Fails &fails) {
    bool removed = false;
    for (std::size_t end = words.size(); end > 0;) {
        const std::size_t begin = end - std::min(end, length);
        Words shorter = words;
        replace(shorter, {begin, std::min(end, shorter.size())}, {});
        if (fails(textOf(shorter))) {
            words = std::move(shorter);
            removed = true;
        }
        end = begin;
    }
    return removed;
}

/// Statements and groups, outer ones first, then arguments.
bool removeParts(Words &words, const Fails &fails) {
    bool removed = false;
    for (const auto parts : {statementsOf, groupsOf, argumentsOf}) {
        for (std::size_t at = 0; at < parts(words).size();) {
            Words shorter = words;
            replace(shorter, parts(words)[at], {});
            if (fails(textOf(shorter))) {
                words = std::move(shorter);
                removed = true;
            } else {
                ++at;
            }
        }
    }
    return removed;
}

/// Comments and blanks of any length become a blank or a line end.
Words withoutComments(Words words) {
    for (Word &word : words)
        if (!word.space.empty())
            word.space = word.space.find('\n') != std::string::npos ? "\n" : " ";
    return words;
}

} // namespace

std::string reduceText(const std::string &text, const Fails &fails) {
    Words words = wordsOf(text);
    if (const Words plain = withoutComments(words); fails(textOf(plain)))
        words = plain;
    for (bool again = true; again;) {
        again = removeParts(words, fails);
        for (std::size_t length = words.size() / 2; length > 0; length /= 2)
            again |= removePieces(words, length, fails);
    }
    if (!words.empty())
        words.front().space.clear();
    return textOf(words);
}

} // namespace candela::fuzz
