// SPDX-License-Identifier: Apache-2.0
// The patterns of printf() and format(), taken apart.
#pragma once

#include "language/semantics/type.h"

#include <string>
#include <vector>

namespace candela::sl {

/// Text, and a conversion behind it unless the pattern ends with the text.
struct PrintPiece {
    std::string text; ///< "%%" is already replaced.
    bool converts = false;
    std::string options; ///< Flags, width and precision: "-8.3" of "%-8.3f".
    char letter = 0;     ///< 0: the pattern ends before it.

    std::string conversion() const;
};

std::vector<PrintPiece> splitPrintPattern(const std::string &pattern);

/// Whether a conversion's letter prints a value of that type.
bool printsType(char letter, BaseType type);

} // namespace candela::sl
