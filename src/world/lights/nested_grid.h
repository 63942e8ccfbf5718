// SPDX-License-Identifier: Apache-2.0
// A density over the unit square that is learned, with a finer one within a rectangle where nearly
// all of it lies: a small view gets next to nothing of a lamp's light.
#pragma once

#include "world/lights/square_grid.h"

#include <array>
#include <optional>

namespace candela {

/// Within the unit square.
struct Rectangle {
    std::array<double, 2> low{0, 0}, size{1, 1};

    double area() const { return size[0] * size[1]; }
    bool holds(double a, double b) const {
        return a >= low[0] && a <= low[0] + size[0] && b >= low[1] && b <= low[1] + size[1];
    }
    /// Of a place, in the rectangle's own measure.
    std::array<double, 2> within(double a, double b) const {
        return {(a - low[0]) / size[0], (b - low[1]) / size[1]};
    }
};

class NestedGrid {
public:
    explicit NestedGrid(SquareGrid whole) : whole_(std::move(whole)) {}
    NestedGrid(SquareGrid whole, SquareGrid part, const Rectangle &where)
        : whole_(std::move(whole)), part_(std::move(part)), where_(where) {}

    /// Of mean 1 over the square.
    double pdf(double a, double b) const;
    /// A place for uniform numbers in [0,1).
    std::array<double, 2> sample(double u, double v) const;

private:
    SquareGrid whole_;
    std::optional<SquareGrid> part_;
    Rectangle where_;
};

} // namespace candela
