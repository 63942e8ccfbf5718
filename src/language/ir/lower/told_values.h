// SPDX-License-Identifier: Apache-2.0
// Values that others tell a shader (option(), lightsource(), surface()...), in the form in which
// they are told: colours in red, green and blue, places in current space, arrays element by
// element.
#pragma once

#include "language/ir/lower/builtins.h"

namespace candela::ir {

/// How many numbers a value of the type is told in; not of strings.
int numbersTold(const sl::Type &);
/// The slots of the parameter block that hold whether the value is there and what it is, which the
/// function gets under that name if it has them not.
Values toldSlots(Builder &, const std::string &hidden, int numbers);
/// The argument, a variable, gets what is told: whether there is a value, and its numbers. It stays
/// as it is if there is none. The result, for the call's, is whether there is one.
ValueId takeTold(BuiltinCall &, size_t argument, const Values &told);

} // namespace candela::ir
