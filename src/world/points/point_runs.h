// SPDX-License-Identifier: Apache-2.0
// The part of evaluation that asks surfaces: a shape at a time, whatever order its points come in.
#pragma once

#include "world/points/point_tables.h"
#include "world/points/shading_points.h"

namespace candela {

/// Fills what the elements do not tell: points and normals of curved surfaces and of those with
/// normals of their own, derivatives, parameters, variables. `normalSign` a point.
void evaluateRuns(const PointTables &, const SurfaceCode &, const float *normalSign,
                  ShadingPoints &);
/// What the surfaces call the points: (piece, u, v), see SurfaceQuery.
void nameRuns(const PointTables &, ShadingPoints &, std::uint32_t *piece, float *u, float *v);

} // namespace candela
