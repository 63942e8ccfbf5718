// SPDX-License-Identifier: Apache-2.0
// Builds light trees top down by the surface-area-orientation heuristic, in twos, and then joins
// the levels to wide nodes.
#pragma once

#include "world/lights/light_tree.h"

namespace candela {

/// At most 64 levels, O(n log n).
void buildLightTree(std::span<const EmitterBound> emitters, LightTree &);

} // namespace candela
