// SPDX-License-Identifier: Apache-2.0
// From the NuPatch record of the interface to a surface.
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/geometry/surface_list.h"

namespace candela {

/// Positions are "P" or "Pw". What lies beyond the range of the knots is not drawn.
SurfaceList makeNuPatch(const NuPatchRecord &, const PrimitiveRecord &, const Attributes &,
                        DiagnosticSink &);

} // namespace candela
