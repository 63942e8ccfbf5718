// SPDX-License-Identifier: Apache-2.0
// Triangles in (u,v), cut along trim curves.
#pragma once

#include "world/geometry/surface.h"
#include "world/geometry/trim_region.h"

namespace candela {

/// What the rule keeps of a mesh that has vertexUv. New vertices stand where the surface says;
/// triangles that share an edge get the same ones on it.
DicedMesh cutAlongTrim(const DicedMesh &, const TrimOutline &, const TrimRule &, const Surface &);

} // namespace candela
