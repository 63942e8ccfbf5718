// SPDX-License-Identifier: Apache-2.0
// The flaws of words, told where the words count.
#pragma once

#include <vector>

#include "language/syntax/reporter.h"
#include "language/syntax/token.h"

namespace candela::sl {

void reportFlaw(const Token &, Reporter &);
/// Tokens that count from here on: their flaws are reported, stray bytes dropped.
std::vector<Token> withoutFlaws(std::vector<Token>, Reporter &);

} // namespace candela::sl
