// SPDX-License-Identifier: Apache-2.0
// The front door of the Shading Language compiler: source text in, typed shaders out.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "foundation/base/diagnostics.h"
#include "language/semantics/typed_ast.h"

namespace candela::sl {

struct SourceText {
    std::string name; ///< The file's name, as messages show it; its folder is searched by #include.
    std::string text;
};

struct FrontOptions {
    std::vector<std::string> includeDirectories;              ///< -I, in the order of search
    std::vector<std::pair<std::string, std::string>> defines; ///< -D name=value
    /// Whether the author is told of what may be meant as it stands (unused variables...).
    bool hints = true;
};

/// All shaders of one file.
struct CompiledFront {
    std::vector<std::unique_ptr<TypedShader>> shaders;
    /// Files that #include brought in, in the order of their first opening: part of the cache key.
    std::vector<std::string> includedFiles;
    std::shared_ptr<const SourceSet> sources;
};

/// Preprocesses, parses and checks a file. Every error of the file is reported, with its line and
/// a caret; nothing is returned if there was one. A file without any shader is an error.
std::optional<CompiledFront> analyzeSource(const SourceText &, const FrontOptions &,
                                           DiagnosticSink &);

} // namespace candela::sl
