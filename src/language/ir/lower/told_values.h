// SPDX-License-Identifier: Apache-2.0
// Values that others tell a shader (option(), lightsource(), surface()...), in the form in which
// they are told: colours in red, green and blue, places in current space, arrays element by
// element.
#pragma once

#include "language/ir/lower/builtins.h"

namespace candela::ir {

/// How many numbers a value of the type is told in; not of strings.
int numbersTold(const sl::Type &);
/// The call's second argument, a variable, gets the value, or stays as it is if there is none.
void assignTold(BuiltinCall &, ValueId isThere, const Values &told);

} // namespace candela::ir
