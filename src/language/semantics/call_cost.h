// SPDX-License-Identifier: Apache-2.0
// What it costs to call a function with arguments of given types: the sum of their conversions, or
// `impossible`.
#pragma once

#include <vector>

#include "language/semantics/builtins.h"
#include "language/semantics/conversion.h"
#include "language/syntax/ast.h"

namespace candela::sl {

int callCost(const BuiltinOverload &, const ast::Expr &call, const std::vector<TypeSet> &arguments);
int callCost(const ast::Function &, const ast::Expr &call, const std::vector<TypeSet> &arguments);

} // namespace candela::sl
