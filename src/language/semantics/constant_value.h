// SPDX-License-Identifier: Apache-2.0
// Expressions of numbers alone, as in the length of an array.
#pragma once

#include <optional>
#include <string>

#include "language/syntax/ast.h"
#include "language/syntax/reporter.h"

namespace candela::sl {

/// The value of an expression of numbers; nothing if there is anything else in it.
std::optional<double> constantValue(const ast::Expr &);

/// Whether an index into `what`, as far as it is known, is in [0, length); reported if not.
bool constantIndexFits(const ast::Expr &index, int length, const std::string &what, Reporter &);

} // namespace candela::sl
