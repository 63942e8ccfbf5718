// SPDX-License-Identifier: Apache-2.0
// Shader sources on disk: found by name, read and checked once.
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/ri/scene_builder.h"
#include "language/semantics/front.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace candela {

/// The name without the endings under which older renderers compiled shaders (.slo, .sdr, ...).
std::string plainShaderName(const std::string &name);

class ShaderSources {
public:
    ShaderSources(std::vector<std::string> folders, DiagnosticSink &diagnostics)
        : folders_(std::move(folders)), diagnostics_(diagnostics) {}

    /// The shader of that name and kind, looked for in `searchPath` and then in the standing
    /// folders; null if there is none or it has errors. Reports why at `where`, once a name.
    const sl::TypedShader *find(ShaderKind, const std::string &name,
                                const std::vector<std::string> &searchPath,
                                const SourceLocation &where);
    /// The same, looked for in these folders alone.
    const sl::TypedShader *findIn(const std::vector<std::string> &folders, ShaderKind,
                                  const std::string &name, const SourceLocation &where);

private:
    const sl::TypedShader *lookFor(const std::vector<std::string> &folders, ShaderKind,
                                   const std::string &name, const SourceLocation &where);
    const sl::CompiledFront *load(const std::string &path);

    std::vector<std::string> folders_;
    DiagnosticSink &diagnostics_;
    std::map<std::string, std::optional<sl::CompiledFront>> files_; ///< By path.
    /// By kind, name and folders: a hundred thousand lights of one shader look for it once.
    std::map<std::string, const sl::TypedShader *> found_;
    std::map<std::string, bool> reported_; ///< By kind and name.
};

} // namespace candela
