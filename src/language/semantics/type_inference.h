// SPDX-License-Identifier: Apache-2.0
// What an expression may be before its context is known. Reports nothing: an empty set means that
// checking the expression will report an error.
#pragma once

#include <vector>

#include "language/semantics/conversion.h"
#include "language/semantics/surroundings.h"
#include "language/syntax/ast.h"

namespace candela::sl {

TypeSet typesOf(const ast::Expr &, const Surroundings &);
/// Of each argument of a call.
std::vector<TypeSet> argumentTypes(const ast::Expr &call, const Surroundings &);

} // namespace candela::sl
