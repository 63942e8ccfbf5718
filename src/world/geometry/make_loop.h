// SPDX-License-Identifier: Apache-2.0
// Subdivision meshes of the scheme "loop".
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/ri/attributes.h"
#include "interface/ri/primitive_record.h"
#include "world/geometry/surface_list.h"

namespace candela {

/// Triangles that are small enough to look smooth, with the limit's normals. Faces of more corners
/// are cut into triangles first, with a warning. The record's numbers must be within bounds.
SurfaceList makeLoop(const SubdivisionRecord &, const PrimitiveRecord &, const Attributes &,
                     DiagnosticSink &);

} // namespace candela
