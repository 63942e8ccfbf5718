// SPDX-License-Identifier: Apache-2.0
// A shader over a grid of points, without a scene: `candela run`.
#pragma once

#include "language/jit/jit.h"

#include <string>
#include <vector>

namespace candela {

struct RunSettings {
    std::string shader;              ///< A file, or a name that is looked for.
    std::vector<std::string> values; ///< NAME=VALUE, as takeValue() reads them.
    int width = 64, height = 64;
    /// A picture: .png, else EXR; empty = numbers on standard output, a line a point.
    std::string output;
    /// The output that is the picture's R, G, B; empty = Ci (lights: Cl; what moves points: P).
    std::string shown;
    /// Of surfaces: what is known of them over each of the grid's boxes (box_grid.h), the picture
    /// being the reflectance's tolerance.
    bool bounds = false;
    std::vector<std::string> shaderPath;
    std::vector<std::string> texturePath; ///< Before the current folder.
    JitOptions jit;                       ///< --lanes
};

/// Compiles the shader and runs its text as it is at each point. The points fill the square from
/// (-1, 1, 0) to (1, -1, 0) row by row; u, v, s and t run over it from 0 to 1, the normal is
/// (0, 0, -1), the eye is far away along it, with one white light there; Cs and Os are 1. An imager
/// gets pixels instead, a light shader the square as what it lights. 0 if all went well, 1 if
/// anything was wrong, which is reported; nothing is written then.
int runShader(const RunSettings &);

} // namespace candela
