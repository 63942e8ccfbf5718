// SPDX-License-Identifier: Apache-2.0
// What a ray stands for of a surface, in the surface's parameters.
#pragma once

#include "world/camera/camera.h"
#include "world/points/shading_points.h"

namespace candela {

/// By point: the widths of the rays' cones, in metres; or, if they are camera rays that know them,
/// their shares of pixels.
struct RayFootprints {
    const float *width = nullptr;
    std::optional<PixelShares> shares;
};

/// Fills dudx, dvdx, dudy, dvdy, uShift, vShift, du and dv; dPdu, dPdv, P, I and Ng are there. The
/// footprint of a cone is an ellipse on the surface around the point: across the way of the ray as
/// wide as the cone, and along it longer, as the surface slants. That of a share of a pixel is what
/// of the surface shows there; its axes are those of the raster and its middle lies beside the
/// point. Axes are in (u,v) and none is beyond 1; du and dv are how far u and v run over all of it.
/// Null = cones of a pixel's width at the points' distances from the camera.
void fillFootprints(const Camera &, const RayFootprints *, ShadingPoints &);

} // namespace candela
