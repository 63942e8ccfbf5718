// SPDX-License-Identifier: Apache-2.0
// How many cells a parameter square is cut into.
#pragma once

#include "world/geometry/surface.h"

namespace candela {

/// Upper bounds over a parameter square of the lengths of a surface's derivatives.
struct DerivativeBounds {
    double du = 0, dv = 0, duu = 0, duv = 0, dvv = 0;
    bool skew = false;  ///< The first derivatives need not be at right angles.
    bool ruled = false; ///< Lines of constant u and of constant v are straight: pure twist.
};

struct DiceCounts {
    int u = 1, v = 1;
};

/// No surface is diced into more cells than this, whatever the rate: two triangles a cell.
inline constexpr double maximalCells = 1 << 20;

/// The largest distance between a triangle whose corners lie in one cell and the surface: between
/// points of the same (u,v), so that the name of a hit is as good as its place. Linear
/// interpolation over weights l_i errs by sum l_i d_i'H d_i / 2, and a quantity that varies by D
/// within the cell has a variance of at most D^2/4.
double cellError(const DerivativeBounds &, DiceCounts);

/// The fewest cells that meet the rate, at least `least`, within `cells` altogether. Pure twist
/// takes as many cells as its size exceeds the chord error, which near the camera is millions for
/// a face that hardly differs from two triangles: there the number grows with the root of that.
DiceCounts chooseCounts(const DerivativeBounds &, const DiceRate &, DiceCounts least, double cells);

} // namespace candela
