// SPDX-License-Identifier: Apache-2.0
// Text to tokens, before the preprocessor: directives are tokens like all others.
#pragma once

#include <vector>

#include "language/syntax/reporter.h"
#include "language/syntax/token.h"

namespace candela::sl {

/// The tokens of a file, an End token last. Comments go to file.comments. A backslash before a
/// line end joins the lines, also with blanks between. Stray bytes, open strings and the like are
/// flaws of their tokens; an open comment is reported.
std::vector<Token> tokenize(SourceFile &file, Reporter &);

} // namespace candela::sl
