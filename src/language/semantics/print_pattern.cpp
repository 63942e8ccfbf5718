// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/print_pattern.h"

#include <algorithm>

namespace candela::sl {

std::string PrintPiece::conversion() const {
    return "%" + options + (letter ? std::string(1, letter) : "");
}

std::vector<PrintPiece> splitPrintPattern(const std::string &pattern) {
    std::vector<PrintPiece> pieces(1);
    for (size_t i = 0; i < pattern.size(); ++i) {
        if (pattern[i] != '%') {
            pieces.back().text += pattern[i];
            continue;
        }
        const size_t first = i + 1;
        i = std::min(pattern.find_first_not_of("0123456789.+- #", first), pattern.size());
        if (i == first && i < pattern.size() && pattern[i] == '%') {
            pieces.back().text += '%';
            continue;
        }
        PrintPiece &piece = pieces.back();
        piece.converts = true;
        piece.options = pattern.substr(first, i - first);
        piece.letter = i < pattern.size() ? pattern[i] : '\0';
        pieces.emplace_back();
    }
    return pieces;
}

bool printsType(char letter, BaseType type) {
    switch (letter) {
    case 'f':
    case 'g':
    case 'e':
    case 'd':
    case 'i': return type == BaseType::Float;
    case 'c':
    case 'p':
    case 'v':
    case 'n': return isTriple(type);
    case 'm': return type == BaseType::Matrix;
    case 's': return type == BaseType::String;
    default: return false;
    }
}

} // namespace candela::sl
