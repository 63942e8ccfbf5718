// SPDX-License-Identifier: Apache-2.0
// What a function starts from: constants, inputs, parameters, coordinate systems, random numbers.
#pragma once

#include "language/ir/core/builder.h"

#include <optional>
#include <string>

namespace candela::ir {

ValueId number(Builder &, float);
ValueId boolean(Builder &, bool);
ValueId integer(Builder &, int);
ValueId text(Builder &, const std::string &);
Triple triple(Builder &, float x, float y, float z);

/// Constant values, if they are: for callers that decide at compile time. Pointers are valid until
/// the next constant is made.
const float *constantFloat(const Builder &, ValueId);
std::optional<bool> constantBool(const Builder &, ValueId);
const std::string *constantText(Builder &, ValueId);

ValueId input(Builder &, ShaderInput, int component = 0);
Triple input3(Builder &, ShaderInput);
ValueId parameter(Builder &, int slot);
ValueId variable(Builder &, int plane);
/// Number `index` of ShaderArgs::captured.
ValueId captured(Builder &, int index);
Matrix currentFromSpace(Builder &, const std::string &name);
Matrix spaceFromCurrent(Builder &, const std::string &name);
Matrix currentFromObject(Builder &);
Matrix objectFromCurrent(Builder &);
/// A new random number at each call site, and for each `turn`, a float.
ValueId random(Builder &, ValueId turn);

} // namespace candela::ir
