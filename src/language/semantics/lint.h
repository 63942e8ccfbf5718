// SPDX-License-Identifier: Apache-2.0
// Habits that the compiler warns about.
#pragma once

#include "language/syntax/ast.h"

namespace candela::sl {

/// Whether the angle of an importance cone, which is in degrees, looks like radians: a literal in
/// (0, 2 pi], or anything that mentions PI (ALGORITHMS section 1).
bool looksLikeRadians(const ast::Expr &angle);

} // namespace candela::sl
