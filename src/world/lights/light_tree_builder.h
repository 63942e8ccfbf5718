// SPDX-License-Identifier: Apache-2.0
// Builds light trees top down by the surface-area-orientation heuristic.
#pragma once

#include "world/lights/light_tree.h"

namespace candela {

/// Fills `nodes` and `trails`. At most 64 levels, O(n log n).
void buildLightTree(std::span<const EmitterBound> emitters, std::vector<LightTree::Node> &nodes,
                    std::vector<std::uint64_t> &trails);

} // namespace candela
