// SPDX-License-Identifier: Apache-2.0
// A density over the unit square, constant in each of its cells: what has been learned of where
// samples are worth most.
#pragma once

#include <array>
#include <vector>

namespace candela {

class SquareGrid {
public:
    static constexpr int side = 128, cells = side * side;

    /// `worth` of each cell, row by row, at least 0; not all 0.
    explicit SquareGrid(const std::vector<double> &worth);

    /// Index of the cell of a place in [0,1]^2.
    static int cellOf(double a, double b);
    /// Of mean 1 over the square.
    double pdf(double a, double b) const { return density_[cellOf(a, b)]; }
    /// A place for uniform numbers in [0,1).
    std::array<double, 2> sample(double u, double v) const;

private:
    std::vector<float> density_;
    std::vector<double> rowSums_;    ///< Running, up to 1.
    std::vector<double> columnSums_; ///< Running within each row, up to 1.
};

} // namespace candela
