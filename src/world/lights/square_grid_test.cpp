// SPDX-License-Identifier: Apache-2.0
#include "world/lights/square_grid.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

constexpr int side = SquareGrid::side;

std::vector<double> worthOf(double (*value)(double a, double b)) {
    std::vector<double> worth(SquareGrid::cells);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            worth[row * side + column] = value((row + .5) / side, (column + .5) / side);
    return worth;
}

TEST(SquareGrid, hasMean1) {
    const SquareGrid grid(worthOf([](double a, double b) { return a * a + b; }));
    double sum = 0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            sum += grid.pdf((row + .5) / side, (column + .5) / side);
    EXPECT_NEAR(sum / SquareGrid::cells, 1, 1e-6);
}

TEST(SquareGrid, isSampledAsItsDensitySays) {
    // The means of a and b under a^2 + b, of integral 5/6: (1/4 + 1/4) and (1/6 + 1/3) over that.
    const SquareGrid grid(worthOf([](double a, double b) { return a * a + b; }));
    constexpr int steps = 500;
    double meanA = 0, meanB = 0, inverse = 0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const auto [a, b] = grid.sample((i + .5) / steps, (k + .5) / steps);
            meanA += a, meanB += b, inverse += 1 / grid.pdf(a, b);
        }
    constexpr double count = double(steps) * steps;
    EXPECT_NEAR(meanA / count, .6, 1e-3);
    EXPECT_NEAR(meanB / count, .6, 1e-3);
    EXPECT_NEAR(inverse / count, 1, 1e-2);
}

TEST(SquareGrid, drawsNothingFromCellsOfNoWorth) {
    const SquareGrid grid(worthOf([](double a, double b) { return a < .5 && b > .75 ? 1. : 0.; }));
    for (double u : {0., .3, .7, 0x1.fffffffffffffp-1})
        for (double v : {0., .3, .7, 0x1.fffffffffffffp-1}) {
            const auto [a, b] = grid.sample(u, v);
            EXPECT_LE(a, .5);
            EXPECT_GE(b, .75);
        }
    EXPECT_EQ(grid.pdf(.7, .8), 0);
    EXPECT_NEAR(grid.pdf(.2, .8), 8, 1e-6);
}

TEST(SquareGrid, takesPlacesOnItsRim) {
    EXPECT_EQ(SquareGrid::cellOf(0, 0), 0);
    EXPECT_EQ(SquareGrid::cellOf(1, 1), SquareGrid::cells - 1);
}

} // namespace
} // namespace candela
