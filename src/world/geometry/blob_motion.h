// SPDX-License-Identifier: Apache-2.0
// Meshes of blobs that move: vertices go with the blobs whose field they are of.
#pragma once

#include "world/geometry/blob_mesh.h"

namespace candela {

/// The mesh of a field on the surface of another one of the same codes, whose blobs are what the
/// field's have become. Nothing if vertices find no surface there, as where blobs part.
std::optional<BlobMesh> carriedTo(const BlobField &to, const BlobField &from, const BlobMesh &);

} // namespace candela
