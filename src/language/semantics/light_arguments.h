// SPDX-License-Identifier: Apache-2.0
// What stands in the parentheses of illuminance, illuminate and solar, classic and with the paper's
// cones (ALGORITHMS 0 and 1).
#pragma once

#include <memory>
#include <vector>

#include "language/semantics/expression_checker.h"
#include "language/semantics/surroundings.h"
#include "language/semantics/typed_ast.h"
#include "language/syntax/ast.h"

namespace candela::sl {

/// Whether the statement may stand here; reported if not.
bool lightStatementAllowed(const ast::Stmt &, const Surroundings &);

struct CheckedLight {
    std::unique_ptr<LightArguments> light;
    /// Calls of lightsource() for arguments such as "light:q", q: they begin the body.
    std::vector<ExprPtr> received;
};
/// Wrong arguments are reported and left out.
CheckedLight checkLightArguments(const ast::Stmt &, const Surroundings &, ExpressionChecker &);

} // namespace candela::sl
