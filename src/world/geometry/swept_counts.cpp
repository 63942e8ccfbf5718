// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/swept_dicing.h"

#include <numbers>

namespace candela {

using std::numbers::pi;

/// The ladder 6, 8, 12, 16, 24, 32...: few counts, so that rates a little apart give the same.
static double onLadder(double cells) {
    double step = 6;
    while (step < cells && step < 2 * maximalCells)
        step = step * 4 / 3 >= cells ? step * 4 / 3 : step * 2;
    return step;
}

/// Cells to a full turn of this radius: diagonals no longer than `edge`, and a quarter of `chord`,
/// as much as a sphere's rows and its twist take where all are in balance.
static double cellsPerTurn(double radius, double edge, double chord) {
    double around = 2 * pi * radius;
    return onLadder(std::max(around * std::sqrt(2.0) / edge, pi * std::sqrt(2 * radius / chord)));
}

/// Derivatives by a full turn and by t.
static DerivativeBounds perTurn(const ProfileLimits &limits) {
    DerivativeBounds bounds = limits.derivatives;
    bounds.du *= 2 * pi, bounds.duu *= 4 * pi * pi, bounds.duv *= 2 * pi;
    return bounds;
}

/// Rows for what the cells round the axis leave of the chord error: the root of a quadratic.
static double rowsFor(const ProfileLimits &limits, double turn, double edge, double chord) {
    DerivativeBounds bounds = perTurn(limits);
    double left = 8 * chord - bounds.duu / (turn * turn), twist = bounds.duv / turn;
    double root = std::sqrt(twist * twist + bounds.dvv * left);
    // A diagonal of a cell that is skew is as long as its two sides together.
    double share = bounds.skew ? 1 - std::sqrt(0.5) : std::sqrt(0.5);
    double rows = std::max((twist + root) / left, bounds.dv / (edge * share));
    return std::max(double(limits.leastRows), std::ceil(rows));
}

SweptCounts chooseSweptCounts(const ProfileLimits &limits, double sweep, int poles,
                              const DiceRate &rate) {
    double extent = limits.extent(), radius = limits.derivatives.du;
    // A rate that is no positive number asks for the finest dicing there is. Beyond the extent
    // nothing gets coarser.
    auto asked = [&](float length) {
        return length > 0 ? std::clamp(double(length), extent * 1e-12, extent * 10)
                          : extent * 1e-12;
    };
    double edge = asked(rate.edgeLength), chord = asked(rate.chordError);
    double turn = 6, rows = 1;
    for (;; edge *= std::sqrt(1.1), chord *= 1.1) {
        turn = cellsPerTurn(radius, edge, chord);
        rows = rowsFor(limits, turn, edge, chord);
        if (turn * rows <= maximalCells)
            break;
    }
    SweptCounts counts;
    counts.turn = int(turn);
    counts.columns = std::max(1, int(std::ceil(turn * std::abs(sweep) / (2 * pi) - 1e-6)));
    counts.rows = poles == 2 ? std::max(2, int(rows)) : int(rows);
    counts.poles = poles;
    return counts;
}

double sweptError(const ProfileLimits &limits, const SweptCounts &counts) {
    return cellError(perTurn(limits), {counts.turn, counts.rows});
}

} // namespace candela
