// SPDX-License-Identifier: Apache-2.0
// Lamps of many elements fall into pieces, which are chosen as one.
#pragma once

#include "world/scene/light_sources.h"

#include <span>

namespace candela {

/// A shape has no more pieces than this.
inline constexpr int mostPieces = 64;

/// Groups of elements: group g has those of order[ends[g - 1]] to order[ends[g]].
struct Pieces {
    std::vector<std::uint32_t> order, ends;
};

/// Groups triangles so that each piece is compact and its normals are alike; areas are of one
/// order. What is small anyway stays together.
Pieces cutToPieces(std::span<const LightElement> triangles);

} // namespace candela
