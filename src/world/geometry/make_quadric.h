// SPDX-License-Identifier: Apache-2.0
// From the quadric records of the interface to surfaces.
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/geometry/surface_list.h"

namespace candela {

SurfaceList makeQuadric(const SphereRecord &, const PrimitiveRecord &, const Attributes &,
                        DiagnosticSink &);
SurfaceList makeQuadric(const ConeRecord &, const PrimitiveRecord &, const Attributes &,
                        DiagnosticSink &);
SurfaceList makeQuadric(const CylinderRecord &, const PrimitiveRecord &, const Attributes &,
                        DiagnosticSink &);
SurfaceList makeQuadric(const HyperboloidRecord &, const PrimitiveRecord &, const Attributes &,
                        DiagnosticSink &);
SurfaceList makeQuadric(const ParaboloidRecord &, const PrimitiveRecord &, const Attributes &,
                        DiagnosticSink &);
SurfaceList makeQuadric(const DiskRecord &, const PrimitiveRecord &, const Attributes &,
                        DiagnosticSink &);
SurfaceList makeQuadric(const TorusRecord &, const PrimitiveRecord &, const Attributes &,
                        DiagnosticSink &);

} // namespace candela
