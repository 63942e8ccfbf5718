// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/visible_text.h"

#include <algorithm>
#include <cstdint>

namespace candela {

namespace {

constexpr std::size_t longestWord = 60, longestPath = 300, longestText = 3000;

/// A character of UTF-8 that begins a text.
struct Character {
    std::size_t length = 1;
    bool isBroken = false; ///< Not UTF-8: the byte stands for itself.
    bool isControl =
        false; ///< Of C0, C1, or one that turns the direction of writing or ends lines.
};

bool isControl(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || (code >= 0x2028 && code <= 0x202e) ||
           (code >= 0x2066 && code <= 0x2069) || code == 0x200e || code == 0x200f || code == 0x61c;
}

Character firstCharacter(std::string_view text) {
    constexpr Character broken{1, true, false};
    const unsigned char first = text[0];
    if (first < 0x80)
        return {1, false, isControl(first)};
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    if (first < 0xc2 || first > 0xf4 || text.size() < length)
        return broken;
    std::uint32_t code = first & (0x7f >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if (!continuesCharacter(text[i]))
            return broken;
        code = code << 6 | (text[i] & 0x3f);
    }
    const bool exists =
        code >= least[length] && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
    return exists ? Character{length, false, isControl(code)} : broken;
}

std::string escaped(unsigned char c) {
    switch (c) {
    case '\n': return "\\n";
    case '\t': return "\\t";
    case '\r': return "\\r";
    }
    constexpr char digits[] = "0123456789abcdef";
    return {'\\', 'x', digits[c >> 4], digits[c & 15]};
}

/// At most `longest` bytes and the dots; the beginning says more than the end.
std::string withoutMiddle(std::string_view text, std::size_t longest) {
    if (text.size() <= longest)
        return std::string(text);
    std::size_t end = longest - longest / 4, begin = text.size() - longest / 4;
    while (end > 0 && continuesCharacter(text[end]))
        --end;
    while (begin < text.size() && continuesCharacter(text[begin]))
        ++begin;
    return std::string(text.substr(0, end)) + "..." + std::string(text.substr(begin));
}

} // namespace

std::string visible(std::string_view text, std::string_view kept,
                    std::vector<std::size_t> *places) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        const Character next = kept.find(text[i]) == std::string_view::npos
                                   ? firstCharacter(text.substr(i))
                                   : Character{};
        for (std::size_t k = 0; places && k < next.length; ++k)
            places->push_back(result.size() + k);
        if (next.isBroken || next.isControl)
            for (std::size_t k = 0; k < next.length; ++k)
                result += escaped(text[i + k]);
        else
            result += text.substr(i, next.length);
        i += next.length;
    }
    if (places)
        places->push_back(result.size());
    return result;
}

bool hasControls(std::string_view text) {
    while (!text.empty()) {
        const Character next = firstCharacter(text);
        if (next.isControl)
            return true;
        text.remove_prefix(next.length);
    }
    return false;
}

std::string shortened(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t blank = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, blank);
        const bool isPath = word.find('/') != std::string_view::npos;
        result += withoutMiddle(word, isPath ? longestPath : longestWord);
        const std::size_t next = std::min(text.find_first_not_of(' ', blank), text.size());
        result += text.substr(blank, next - blank);
        text.remove_prefix(next);
    }
    return withoutMiddle(result, longestText);
}

} // namespace candela
