// SPDX-License-Identifier: Apache-2.0
// Texts of unknown origin made fit to be shown on a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace candela {

/// True within a character of UTF-8.
inline bool continuesCharacter(char c) { return (c & 0xc0) == 0x80; }

/// The text with all that is not a printable character of UTF-8 written as \n, \t, \r or \xHH:
/// control characters, what turns the direction of writing, broken characters; but for those of
/// `kept`. `places`, if given, is filled with where each byte of the text, and its end, then
/// stands.
std::string visible(std::string_view text, std::string_view kept = {},
                    std::vector<std::size_t> *places = nullptr);

/// True if there are control characters in it, or such that turn the direction of writing.
bool hasControls(std::string_view text);

/// The text with dots in the middle of words of more than 60 bytes, of paths of more than 300, and
/// in its own beyond 3000: what files hold may be of any length.
std::string shortened(std::string_view text);

} // namespace candela
