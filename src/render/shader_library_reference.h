// SPDX-License-Identifier: Apache-2.0
// The library of shaders as the reference has it.
#pragma once

#include "foundation/base/diagnostics.h"
#include "language/semantics/front.h"

#include <string>
#include <vector>

namespace candela {

/// An entry for each shader of a source; `folders` are searched by #include.
std::vector<std::string> shaderEntries(const sl::SourceText &,
                                       const std::vector<std::string> &folders, DiagnosticSink &);

/// Of the library: the shaders of that name, of a kind ("surfaces" to "filters") or all
/// ("shaders"), by kinds and names.
std::vector<std::string> libraryShaderEntries(const std::string &word);

/// Shaders are named as their files are.
std::vector<std::string> libraryShaderNames();

} // namespace candela
