// SPDX-License-Identifier: Apache-2.0
// What `candela run` has found out.
#pragma once

#include <string>
#include <vector>

namespace candela {

/// Numbers of all points under a name: "Ci", three of them.
struct NamedPlanes {
    std::string name;
    std::vector<std::vector<float>> planes;
    std::vector<int> slots{}; ///< Of the question's outputs, for each plane.
};

} // namespace candela
