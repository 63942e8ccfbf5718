// SPDX-License-Identifier: Apache-2.0
// Shader parameters and their default values.
#pragma once

#include "language/ir/lower/lower.h"

#include <optional>
#include <vector>

namespace candela::ir {

/// The shader's parameters, all firstSlot -1. A default may call functions and read the parameters
/// before it, whose defaults (for strings: the values given) it sees. One that is not a constant
/// is reported; nothing is returned then.
std::optional<std::vector<ShaderParameter>> parametersOf(const sl::TypedShader &,
                                                         const std::vector<StringValue> &strings,
                                                         const ColorBasis &, DiagnosticSink &);

} // namespace candela::ir
