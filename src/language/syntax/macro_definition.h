// SPDX-License-Identifier: Apache-2.0
// The line of a #define.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "language/syntax/macro.h"
#include "language/syntax/reporter.h"
#include "language/syntax/token.h"

namespace candela::sl {

struct MacroDefinition {
    std::string name;
    Macro macro;
};

/// Reads what stands behind the word "define"; nothing if it is wrong, which is reported.
std::optional<MacroDefinition> readDefinition(const std::vector<Token> &line,
                                              const Token &directive, Reporter &);

} // namespace candela::sl
