// SPDX-License-Identifier: Apache-2.0
// What a ray's cone covers of a surface, in the surface's parameters.
#pragma once

#include "world/camera/camera.h"
#include "world/points/shading_points.h"

namespace candela {

/// Fills dudx, dvdx, dudy, dvdy, du and dv; dPdu, dPdv, P, I and Ng are there. A footprint is an
/// ellipse on the surface: across the way of the ray as wide as its cone, `width` metres, and along
/// it longer, as the surface slants. Its axes x and y, in (u,v) and none beyond 1, are these two; du
/// and dv are how far u and v run over all of it. `width` null = a pixel's at its distance from the
/// camera.
void fillFootprints(const Camera &, const float *width, ShadingPoints &);

} // namespace candela
