// SPDX-License-Identifier: Apache-2.0
// What a declaration says: type, length and initial values of a variable.
#pragma once

#include <optional>
#include <vector>

#include "language/semantics/expression_checker.h"
#include "language/semantics/typed_ast.h"
#include "language/syntax/ast.h"
#include "language/syntax/reporter.h"

namespace candela::sl {

inline constexpr int arrayLimit = 1 << 16;

/// Of a local or a formal that states none.
constexpr Detail naturalDetail(BaseType type) {
    return type == BaseType::String ? Detail::Uniform : Detail::Varying;
}

/// Stated, or as many as there are initial values; nothing if it is wrong, which is reported.
std::optional<int> arrayLength(const ast::Variable &, Reporter &);
/// The type, whose detail is `natural` if none is stated.
Type declaredType(const ast::Variable &, Detail natural, Reporter &);
/// The values that are right, for a variable of that type; the others are reported.
std::vector<ExprPtr> initialValues(const ast::Variable &, const Type &, ExpressionChecker &,
                                   Reporter &);

} // namespace candela::sl
