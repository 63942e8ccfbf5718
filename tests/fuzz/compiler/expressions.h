// SPDX-License-Identifier: Apache-2.0
// Random expressions of the Shading Language that have a given type: what mutation alone seldom
// makes, the built-in functions on all sorts of arguments.
#pragma once

#include "chance.h"

#include "language/syntax/base_type.h"

#include <string>

namespace candela::fuzz {

/// Of numbers, a surface shader's variables, operators and built-in functions without outputs, so
/// many levels high at most.
std::string randomExpression(sl::BaseType, int height, Chance &);

/// A statement that adds random expressions to a surface's Ci or Oi, perhaps under a condition.
std::string randomStatement(Chance &);

} // namespace candela::fuzz
