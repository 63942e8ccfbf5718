// SPDX-License-Identifier: Apache-2.0
// Tokens to syntax tree.
#pragma once

#include <vector>

#include "language/syntax/ast.h"
#include "language/syntax/reporter.h"
#include "language/syntax/token.h"

namespace candela::sl {

/// Parses a preprocessed file. Every syntax error is reported; after one the parser goes on with
/// the next statement or declaration, so that the tree holds what could be understood.
ast::File parse(const std::vector<Token> &tokens, Reporter &);

} // namespace candela::sl
