// SPDX-License-Identifier: Apache-2.0
// A shader as the reference and `candela info` tell of it.
#pragma once

#include "foundation/base/diagnostics.h"
#include "language/ir/lower/lower.h"
#include "language/semantics/typed_ast.h"

#include <string>

namespace candela {

/// A comment in one line, the licence's words apart.
std::string inOneLine(const std::string &comment);

/// "float Ka = 1", "point from = "shader" (0, 0, 0)", "output varying color layers[2] = { ... }"
std::string declarationOf(const ir::ShaderParameter &);

/// Kind, name and parameters; what the comment before the shader says; a line a parameter: its
/// declaration and comment.
std::string entryOf(const sl::TypedShader &, DiagnosticSink &);

} // namespace candela
