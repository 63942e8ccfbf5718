// SPDX-License-Identifier: Apache-2.0
// From the subdivision mesh record of the interface to a surface.
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/geometry/surface_list.h"

namespace candela {

SurfaceList makeSubdivision(const SubdivisionRecord &, const PrimitiveRecord &, const Attributes &,
                            DiagnosticSink &);

/// What is said of meshes of every scheme.
void reportStrayCreases(int strays, const SourceLocation &, DiagnosticSink &);
void reportNothingDrawn(const SourceLocation &, DiagnosticSink &);

} // namespace candela
