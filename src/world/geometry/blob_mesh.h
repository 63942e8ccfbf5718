// SPDX-License-Identifier: Apache-2.0
// The surface of a field of blobs as triangles: one vertex in each cell of a grid that the surface
// passes through, moved onto it (surface nets, Gibson 1998).
#pragma once

#include "world/geometry/blob_field.h"

#include <array>

namespace candela {

struct BlobMesh {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals; ///< Of length 1, out of the blobs.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    /// Cells that the smallest blob is across. Fewer than a handful may miss it.
    float cellsAcross = 0;
};

/// With fewer cells across them blobs are drawn coarsely, or not at all.
inline constexpr float fewestCellsAcross = 10;

/// Triangles whose (p1 - p0) x (p2 - p0) points out of the blobs. Cells are a share of the smallest
/// blob's size, or larger where that were too many.
BlobMesh meshOf(const BlobField &);

} // namespace candela
