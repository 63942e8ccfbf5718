// SPDX-License-Identifier: Apache-2.0
// gather(category, p, axis, angle, samples, "name", value...) statement else statement (RI 3.2.1).
#pragma once

#include "language/semantics/expression_checker.h"
#include "language/semantics/surroundings.h"
#include "language/semantics/typed_ast.h"
#include "language/syntax/ast.h"

#include <optional>
#include <vector>

namespace candela::sl {

/// The parts of the Loop that a gather statement becomes.
struct GatherLoop {
    std::vector<StmtPtr> declarations; ///< How many rays have been followed; random numbers.
    ExprPtr more;                      ///< The loop's condition.
    ExprPtr next;                      ///< Its step.
    ExprPtr hit;                       ///< Follows a ray: 1 if it meets something.
};

/// Nothing, with a report, if the arguments are wrong.
std::optional<GatherLoop> checkGather(const ast::Stmt &, Surroundings &, ExpressionChecker &);

} // namespace candela::sl
