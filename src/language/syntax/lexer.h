// SPDX-License-Identifier: Apache-2.0
// Text to tokens, before the preprocessor: directives are tokens like all others.
#pragma once

#include <vector>

#include "language/syntax/reporter.h"
#include "language/syntax/token.h"

namespace candela::sl {

/// The tokens of a file, an End token last. Comments go to file.comments. A backslash before a
/// line end joins the lines. Stray bytes and open comments or strings are reported and skipped.
std::vector<Token> tokenize(SourceFile &file, Reporter &);

} // namespace candela::sl
