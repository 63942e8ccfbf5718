// SPDX-License-Identifier: Apache-2.0
// Arguments of built-in functions that are known now and mean something are checked now: names of
// colour spaces and bases, patterns of printf(), numbers of components.
#pragma once

#include <vector>

#include "language/semantics/builtins.h"
#include "language/semantics/typed_ast.h"
#include "language/syntax/ast.h"
#include "language/syntax/reporter.h"

namespace candela::sl {

/// Reports strings that name nothing, and patterns that do not fit what is printed.
void checkStrings(const ast::Expr &call, BuiltinId, const std::vector<ExprPtr> &arguments,
                  Reporter &);

/// Of xcomp() and its like, which are about vectors: warns of colors.
void warnOfColorAsVector(const ast::Expr &call, const BuiltinOverload &, Reporter &);

/// Of comp() and setcomp(): whether the components exist; reported if not. True of others.
bool componentsExist(const ast::Expr &call, const BuiltinOverload &, Reporter &);

} // namespace candela::sl
