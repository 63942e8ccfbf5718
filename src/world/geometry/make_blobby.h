// SPDX-License-Identifier: Apache-2.0
// Surfaces of RiBlobby.
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/geometry/surface_list.h"

namespace candela {

/// A mesh with smooth normals. Values of class vertex and varying, one a blob, blend as their
/// fields do.
SurfaceList makeBlobby(const PrimitiveRecord &, DiagnosticSink &);
/// Of what it is at even steps over the shutter's interval.
SurfaceList makeMovingBlobby(const std::vector<std::shared_ptr<const PrimitiveRecord>> &,
                             DiagnosticSink &);

} // namespace candela
