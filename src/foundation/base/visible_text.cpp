// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/visible_text.h"

#include <algorithm>
#include <cstdint>

namespace candela {

namespace {

constexpr std::size_t longestWord = 300, longestText = 3000;

/// Length of the printable character that begins the text; 0 if none does.
std::size_t printableLength(std::string_view text) {
    const unsigned char first = text[0];
    if (first < 0x80)
        return first >= 0x20 && first != 0x7f;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    constexpr std::uint32_t least[] = {0, 0, 0xa0, 0x800, 0x10000}; // Below 0xa0: controls.
    if (first < 0xc2 || first > 0xf4 || text.size() < length)
        return 0;
    std::uint32_t code = first & (0x7f >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if (!continuesCharacter(text[i]))
            return 0;
        code = code << 6 | (text[i] & 0x3f);
    }
    const bool turns = (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) ||
                       code == 0x200e || code == 0x200f || code == 0x61c;
    const bool exists =
        code >= least[length] && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
    return exists && !turns ? length : 0;
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
        const std::size_t length =
            kept.find(text[i]) != std::string_view::npos ? 1 : printableLength(text.substr(i));
        const std::size_t bytes = std::max<std::size_t>(1, length);
        for (std::size_t k = 0; places && k < bytes; ++k)
            places->push_back(result.size() + k);
        result += length ? std::string(text.substr(i, length)) : escaped(text[i]);
        i += bytes;
    }
    if (places)
        places->push_back(result.size());
    return result;
}

std::string shortened(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t blank = std::min(text.find(' '), text.size());
        result += withoutMiddle(text.substr(0, blank), longestWord);
        const std::size_t next = std::min(text.find_first_not_of(' ', blank), text.size());
        result += text.substr(blank, next - blank);
        text.remove_prefix(next);
    }
    return withoutMiddle(result, longestText);
}

} // namespace candela
