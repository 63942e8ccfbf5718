// SPDX-License-Identifier: Apache-2.0
#include "world/lights/square_grid.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace candela {

namespace {

/// The first sum beyond `x`; x becomes a uniform number within its step.
int find(std::span<const double> sums, double &x) {
    const int k = int(std::min<std::ptrdiff_t>(
        std::upper_bound(sums.begin(), sums.end(), x) - sums.begin(), std::ssize(sums) - 1));
    const double below = k > 0 ? sums[k - 1] : 0, step = sums[k] - below;
    x = step > 0 ? std::clamp((x - below) / step, 0.0, 1.0) : 0.5;
    return k;
}

void addUp(std::span<const double> values, std::span<double> sums) {
    std::partial_sum(values.begin(), values.end(), sums.begin());
    const double all = sums.back();
    for (double &sum : sums)
        sum = all > 0 ? sum / all : 1;
}

} // namespace

SquareGrid::SquareGrid(const std::vector<double> &worth)
    : density_(cells), rowSums_(side), columnSums_(cells) {
    const double all = std::accumulate(worth.begin(), worth.end(), 0.0);
    std::array<double, side> ofRow{};
    for (int row = 0; row < side; ++row) {
        const std::span<const double> values(worth.data() + row * side, side);
        ofRow[row] = std::accumulate(values.begin(), values.end(), 0.0);
        addUp(values, std::span(columnSums_).subspan(row * side, side));
    }
    addUp(ofRow, rowSums_);
    for (int cell = 0; cell < cells; ++cell)
        density_[cell] = float(worth[cell] / all * cells);
}

int SquareGrid::cellOf(double a, double b) {
    const int row = std::clamp(int(a * side), 0, side - 1);
    return row * side + std::clamp(int(b * side), 0, side - 1);
}

std::array<double, 2> SquareGrid::sample(double u, double v) const {
    const int row = find(rowSums_, u);
    const int column = find(std::span(columnSums_).subspan(row * side, side), v);
    return {(row + u) / side, (column + v) / side};
}

} // namespace candela
