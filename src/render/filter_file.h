// SPDX-License-Identifier: Apache-2.0
// A stack of filters on a stored picture: `candela filter`.
#pragma once

#include "language/jit/jit.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace candela {

struct FilterFileSettings {
    std::string input, output;
    std::vector<std::string> filters; ///< As readFilters() takes them.
    std::vector<std::string> kept;    ///< Maps that filters make and that are written, too.
    /// Gain and gamma of what is written; unset = 1 1, and for PNG the curve of sRGB.
    std::optional<std::array<float, 2>> exposure;
    std::vector<std::string> shaderPath;
    int threads = 0; ///< 0 = all cores.
    bool quiet = false;
    JitOptions jit; ///< --lanes
};

/// Reads the picture, runs the filters in their order and writes its channels, whole or not
/// at all. 0 if all went well, 1 if anything was wrong (and reported; where a picture or a filter
/// is not to be had nothing is written), statusOfInterrupt after Ctrl-C, when nothing is.
int filterFile(const FilterFileSettings &);

/// Prints the filters of the library and of the shader path: a line each, name, parameters with
/// their types, and what the text's first comment says. 0, or 1 if some have errors.
int listFilters(const FilterFileSettings &);

} // namespace candela
