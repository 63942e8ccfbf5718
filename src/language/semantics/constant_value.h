// SPDX-License-Identifier: Apache-2.0
// Expressions of numbers alone, as in the length of an array.
#pragma once

#include <optional>

#include "language/syntax/ast.h"

namespace candela::sl {

/// The value of an expression of numbers; nothing if there is anything else in it.
std::optional<double> constantValue(const ast::Expr &);

} // namespace candela::sl
