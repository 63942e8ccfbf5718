// SPDX-License-Identifier: Apache-2.0
// Making the nodes of the typed tree. For the checker only.
#pragma once

#include <string>
#include <vector>

#include "language/semantics/typed_ast.h"
#include "language/syntax/reporter.h"

namespace candela::sl {

/// A single value of a type; its detail comes from the operands.
constexpr Type single(BaseType base) { return {base, Detail::Uniform, 0}; }

/// Those that are not null.
std::vector<ExprPtr> list(ExprPtr, ExprPtr = nullptr, ExprPtr = nullptr);

/// Varying if the type or one of the operands is.
ExprPtr makeNode(ExprKind, const Type &, const Place &, std::vector<ExprPtr> operands = {});
ExprPtr makeNumber(double, const Place &);
/// 0 of a type; "" of a string.
ExprPtr makeZero(BaseType, const Place &);
ExprPtr makeText(const std::string &, const Place &);
ExprPtr makeBinary(BinaryOp, BaseType result, const Place &, ExprPtr left, ExprPtr right);
ExprPtr makeVariable(Symbol &, const Place &);
StmtPtr makeNode(StmtKind, const Place &);

/// The value with a conversion to the type behind it.
ExprPtr converted(ExprPtr, BaseType);
/// The value as a type to which it converts by itself. Null stays null; what does not convert is
/// reported as "<role> must be a ..." and becomes null.
ExprPtr coerce(ExprPtr, BaseType, const std::string &role, Reporter &);

} // namespace candela::sl
