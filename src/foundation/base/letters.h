// SPDX-License-Identifier: Apache-2.0
// Words whose letters may be large or small.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace candela {

inline std::string inSmallLetters(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

} // namespace candela
