// SPDX-License-Identifier: Apache-2.0
// The C-like preprocessor of the Shading Language.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "language/syntax/reporter.h"
#include "language/syntax/token.h"

namespace candela::sl {

struct PreprocessorOptions {
    std::vector<std::string> includeDirectories; ///< Searched in this order.
    /// Macros that are defined from the start, besides CANDELA (the version as a number:
    /// major*10000 + minor*100 + patch), CANDELA_VERSION (a string), __LINE__ and __FILE__.
    std::vector<std::pair<std::string, std::string>> defines;
};

struct PreprocessedFile {
    std::vector<Token> tokens;              ///< Without directives; an End token last.
    std::vector<std::string> includedFiles; ///< In the order of their first opening.
};

/// Runs the preprocessor over sources.front(); files that it includes are appended to sources.
/// Knows #include, #define (also with parameters, # and ##), #undef, #if, #ifdef, #ifndef, #elif,
/// #else, #endif, #error, #warning; ignores #pragma, #line and #ident. Errors are reported; what
/// can be used of the file is returned all the same.
PreprocessedFile preprocess(SourceSet &sources, const PreprocessorOptions &, Reporter &);

} // namespace candela::sl
