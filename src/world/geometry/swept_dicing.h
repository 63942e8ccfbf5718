// SPDX-License-Identifier: Apache-2.0
// The triangles of a swept surface: a grid in (u, t) that closes at the seam and at the poles.
#pragma once

#include "world/geometry/dice_counts.h"

namespace candela {

struct SweptGrid {
    DiceCounts cells;                      ///< At least two rows if both ends are poles.
    bool closedU = false, closedV = false; ///< The last column or row falls on the first.
    Vec3 first, last;                      ///< The profile's ends.
    float poleRadius = 0;                  ///< An end this near to the axis is a pole.
};

/// Positions come from evaluate(), but are the very same floats where the surface meets itself:
/// no cracks. chordError is left to the caller.
DicedMesh diceSwept(const SweptGrid &, const Surface &);

} // namespace candela
