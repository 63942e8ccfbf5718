// SPDX-License-Identifier: Apache-2.0
// Shader parameters and their default values.
#pragma once

#include "language/ir/lower/lower.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace candela::ir {

/// The shader's parameters, all firstSlot -1. A default may call functions and read the parameters
/// before it, whose defaults (for strings: the values given) it sees. One that is not a constant
/// is reported; nothing is returned then. `needed` gets the parameters of which a default needs a
/// string that is left to run time: what is returned is of no use then.
std::optional<std::vector<ShaderParameter>>
parametersOf(const sl::TypedShader &, const std::vector<StringValue> &strings, const ColorBasis &,
             std::set<std::string> &needed, DiagnosticSink &);
/// Where no strings are given.
std::optional<std::vector<ShaderParameter>> parametersOf(const sl::TypedShader &,
                                                         const ColorBasis &, DiagnosticSink &);

} // namespace candela::ir
