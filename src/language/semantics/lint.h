// SPDX-License-Identifier: Apache-2.0
// Habits that the compiler warns about.
#pragma once

#include "language/syntax/ast.h"

namespace candela::sl {

/// Whether the angle of an importance cone, which is in degrees, looks like radians: a
/// literal that is some twelfths of pi, or anything that mentions PI.
bool looksLikeRadians(const ast::Expr &angle);
/// Whether an angle, which is in radians, looks like degrees: a literal multiple of 5 above 2 pi,
/// or what degrees() gives.
bool looksLikeDegrees(const ast::Expr &angle);

} // namespace candela::sl
