// SPDX-License-Identifier: Apache-2.0
// Directions and places on latitude-longitude pictures (RI 3.2, 7.1.2): longitude 0 is the left
// edge and grows from +x by +y, latitude 90 degrees, +z, is the top.
#pragma once

#include "foundation/base/vec3.h"

namespace candela {

/// A direction and how it changes along the axes of a footprint, or the like of a place.
struct DirectionReach {
    Vec3 direction, x, y; ///< Of any length, the changes of that direction.
};
struct PlaceReach {
    float s = 0, t = 0, dsdx = 0, dtdx = 0, dsdy = 0, dtdy = 0;
};

/// Where on the picture the direction shows, and how far it reaches there. Of what lies within half
/// a pixel of a pole (`columns` of pixels stand around it) all that is at its latitude is meant, so
/// that poles are whole.
PlaceReach latLongPlace(const DirectionReach &, int columns);

/// The unit direction of a place.
Vec3 latLongDirection(float s, float t);

} // namespace candela
