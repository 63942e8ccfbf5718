// SPDX-License-Identifier: Apache-2.0
// Points on elements become shading points on the true surface, in current space. Evaluation is a
// row of stages: locate (what the point lies on), geometry (in the shape's own space), place (by
// the instance), variables, footprint.
#pragma once

#include "world/points/footprint.h"
#include "world/points/point_tables.h"
#include "world/points/shading_points.h"

namespace candela {

/// Evaluates points of which the caller has filled in: instance, shape, element, u and v; P, the
/// point on the element, and Ng, the element's normal of any length, both in current space, Ng not
/// yet turned; I, from where they are seen (0 = from nowhere); and count. All shapes share `code`.
/// Fills all else but E; time must be there already. `rays` are those that have met the points, as
/// fillFootprints() has them.
void evaluatePoints(const PointTables &, const Camera &, const SurfaceCode &code,
                    const RayFootprints *rays, ShadingPoints &);

/// Normals of elements on instances, from object to current space; `count` points.
void placeElementNormals(const PointTables &, int count, const std::uint32_t *instance,
                         const float *time, float *const *Ng);

/// ShaderArgs for a question about the points.
void bindPoints(const PointTables &, int code, const ShadingPoints &, ShaderArgs &);

} // namespace candela
