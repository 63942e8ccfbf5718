// SPDX-License-Identifier: Apache-2.0
// From the patch mesh record of the interface to a surface.
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/geometry/surface_list.h"

namespace candela {

/// Positions are "P", "Pw" or the height field "Pz", whose x and y are the u and v of the mesh.
SurfaceList makePatchMesh(const PatchMeshRecord &, const PrimitiveRecord &, const Attributes &,
                          DiagnosticSink &);

} // namespace candela
