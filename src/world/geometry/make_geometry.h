// SPDX-License-Identifier: Apache-2.0
// What RiGeometry knows by name: "teapot".
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/geometry/surface_list.h"

namespace candela {

/// A surface for each patch, whose variables of class constant, uniform and varying are those of
/// the primitive.
SurfaceList makeGeometry(const GeometryRecord &, const PrimitiveRecord &, const Attributes &,
                         DiagnosticSink &);

} // namespace candela
