// SPDX-License-Identifier: Apache-2.0
// Optional arguments by name, as in occlusion(P, N, 16, "environmentdir", dir): which of them a
// function reads, and which it sets.
#pragma once

#include <string_view>

#include "language/semantics/typed_ast.h"
#include "language/syntax/ast.h"

namespace candela::sl {

/// Whether behind that name stands a variable that the function sets.
bool isResultName(BuiltinId, std::string_view name);
/// Whether operand i of the call (of the untyped tree), which has parameters for fewer, is one.
bool isNamedResult(BuiltinId, const ast::Expr &call, size_t i);
/// Whether a call of a built-in function (of the typed tree) sets its i-th operand, be it by a
/// parameter or by name.
bool setsOperand(const Expr &call, size_t i);
/// The operand behind the name, from operand `first` on; null if it is not there.
const Expr *namedOperand(const Expr &call, size_t first, std::string_view name);

} // namespace candela::sl
