// SPDX-License-Identifier: Apache-2.0
// The triangles of a swept surface: a grid in (u, t) that closes at the seam and at the poles.
// Where two surfaces share a rim and are diced at one rate, the rim has the same vertices in both,
// to the last bit: the cells round the axis depend on nothing but the greatest radius and the rate.
#pragma once

#include "world/geometry/profile.h"

#include <span>

namespace candela {

/// Cells round the axis and along the profile.
struct SweptCounts {
    int turn = 6;    ///< To a full turn, of a ladder whose steps are at most half as much again.
    int columns = 6; ///< Of these within the sweep; the last may be narrower.
    int rows = 1;
    int poles = 0; ///< Ends of the profile on the axis, where one triangle makes a cell.

    double triangles() const { return double(columns) * (2.0 * rows - poles); }
};

/// `sweep` in radians, of either sign; `poles` ends of the profile are on the axis.
SweptCounts chooseSweptCounts(const ProfileLimits &, double sweep, int poles, const DiceRate &);

/// cellError of the cells, in object units.
double sweptError(const ProfileLimits &, const SweptCounts &);

struct SweptGrid {
    SweptCounts counts;
    double sweep = 0;          ///< Radians.
    bool closedV = false;      ///< The last row falls on the first.
    std::span<const Vec3> row; ///< The profile at each of the rows + 1 rows.
    float poleRadius = 0;      ///< An end this near to the axis is a pole.
};

/// Positions are the very same floats where the surface meets itself: no cracks. chordError is left
/// to the caller.
DicedMesh diceSwept(const SweptGrid &);

} // namespace candela
