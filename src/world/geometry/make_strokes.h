// SPDX-License-Identifier: Apache-2.0
// From the points and curves of the interface to surfaces.
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/geometry/surface.h"

namespace candela {

/// Widths are "width" or "constantwidth", 1 without; what is negative counts as 0.
std::vector<std::shared_ptr<const Surface>>
makePoints(const PointsRecord &, const PrimitiveRecord &, const Attributes &, DiagnosticSink &);
std::vector<std::shared_ptr<const Surface>>
makeCurves(const CurvesRecord &, const PrimitiveRecord &, const Attributes &, DiagnosticSink &);

} // namespace candela
