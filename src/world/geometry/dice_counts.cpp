// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/dice_counts.h"

#include <algorithm>
#include <cmath>

namespace candela {

double cellError(const DerivativeBounds &bounds, DiceCounts counts) {
    double du = 1.0 / counts.u, dv = 1.0 / counts.v;
    return (bounds.duu * du * du + 2 * bounds.duv * du * dv + bounds.dvv * dv * dv) / 8;
}

/// Cells along one side for edges of at most `edge`, by a side's length.
static double cellsForEdge(double length, bool skew, double edge) {
    // A diagonal is the longest edge of a cell's triangles.
    double cells = std::ceil(length * (skew ? 2 : std::sqrt(2.0)) / edge);
    return cells >= 1 ? std::min(cells, maximalCells) : 1; // NaN and "no limit" give 1.
}

/// Which side to cut finer. Where twist matters most cells are kept about as long as wide: slivers
/// of a twisted strip come near to the surface without ever lying in it.
static bool refineU(const DerivativeBounds &bounds, double u, double v) {
    double errorU = bounds.duu / (u * u), errorV = bounds.dvv / (v * v);
    if (2 * bounds.duv / (u * v) > errorU + errorV)
        return bounds.du / u >= bounds.dv / v;
    return errorU >= errorV;
}

DiceCounts chooseCounts(const DerivativeBounds &bounds, const DiceRate &rate, DiceCounts least,
                        double cells) {
    // A rate that is no positive number asks for the finest dicing there is.
    double edge = rate.edgeLength > 0 ? double(rate.edgeLength) : 0.0;
    double chord = rate.chordError > 0 ? double(rate.chordError) : 0.0;
    if (bounds.ruled)
        chord = std::max(chord, std::sqrt(chord * bounds.duv) / 64);
    double u = std::max(double(least.u), cellsForEdge(bounds.du, bounds.skew, edge));
    double v = std::max(double(least.v), cellsForEdge(bounds.dv, bounds.skew, edge));
    auto error = [&] {
        return (bounds.duu / (u * u) + 2 * bounds.duv / (u * v) + bounds.dvv / (v * v)) / 8;
    };
    // Growth by a constant factor: some hundred steps at the very most.
    while (error() > chord && u * v < cells) {
        double &side = refineU(bounds, u, v) ? u : v;
        side = std::ceil(side * 1.07 + 0.5);
    }
    if (double excess = std::sqrt(u * v / cells); excess > 1) {
        u = std::max(double(least.u), std::min(u / excess, cells));
        v = std::max(double(least.v), std::min(v / excess, cells / u));
    }
    return {std::max(1, int(u)), std::max(1, int(v))};
}

} // namespace candela
