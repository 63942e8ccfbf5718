// SPDX-License-Identifier: Apache-2.0
// Points that are given in world space, as the scene has them: in current space, in floats.
#pragma once

#include "foundation/base/vec3.h"
#include "light/probe/probe.h"

namespace candela {

struct PlacedPoint {
    Vec3 P;
    Vec3 origin; ///< Where rays begin.
    Vec3 aim;    ///< Unit: the normal, or the direction.
    int number;
};

/// A normal keeps its side of its plane however the camera's space is stretched or mirrored; a
/// direction goes the way its points go. Sensors stand a little off their points.
PlacedPoint place(const ProbePoint &, const Scene &, const ProbeSettings &);

} // namespace candela
