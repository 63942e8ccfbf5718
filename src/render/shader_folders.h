// SPDX-License-Identifier: Apache-2.0
// Where shaders are looked for after the RIB's own search path (DESIGN section 9).
#pragma once

#include "foundation/base/diagnostics.h"

#include <string>
#include <vector>

namespace candela {

struct ShaderFolders {
    /// --shader-path, the RIB's folder, the current folder, $CANDELA_SHADERS, the shipped library;
    /// each with its sub-folders by kind (surface, light, ..., include) where these exist.
    std::vector<std::string> all;
    /// The library alone: the one that is shipped, else those that $CANDELA_SHADERS names.
    std::vector<std::string> library;
};

/// Warns if the shipped library is not to be found and the variable does not say where another one
/// is.
ShaderFolders shaderFolders(const std::string &ribFile, const std::vector<std::string> &shaderPath,
                            DiagnosticSink &);

/// "a:b:c"
std::string joinFolders(const std::vector<std::string> &folders);

} // namespace candela
