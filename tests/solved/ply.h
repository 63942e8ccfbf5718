// SPDX-License-Identifier: Apache-2.0
// Meshes of solutions, as --solution-mesh writes them.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace candela::test {

/// The numbers of a PLY file: vertices with all of their properties, and faces.
struct Ply {
    std::vector<std::array<float, 9>> vertices;
    std::vector<std::vector<int>> faces;
};

Ply readPly(const std::string &bytes);

} // namespace candela::test
