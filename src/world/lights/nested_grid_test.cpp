// SPDX-License-Identifier: Apache-2.0
#include "world/lights/nested_grid.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

SquareGrid rising() {
    std::vector<double> worth;
    for (int row = 0; row < SquareGrid::side; ++row)
        worth.insert(worth.end(), SquareGrid::side, row + 1.0);
    return SquareGrid(worth);
}

constexpr Rectangle rectangles[] = {
    {{.25, .5}, {.125, .25}}, {{.7, .1}, {.002, .003}}, {{0, 0}, {.5, 1}}};

class NestedGrids : public testing::TestWithParam<Rectangle> {};

TEST_P(NestedGrids, AreSampledAsTheirDensitySays) {
    const Rectangle &where = GetParam();
    const NestedGrid grid(rising(), rising(), where);
    constexpr int steps = 1000;
    double inverse = 0;
    int inside = 0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const auto [a, b] = grid.sample((i + .5) / steps, (k + .5) / steps);
            inverse += 1 / grid.pdf(a, b);
            inside += where.holds(a, b);
        }
    constexpr double count = double(steps) * steps;
    EXPECT_NEAR(inverse / count, 1, .02); // The area of the square.
    // 80 % are drawn there, and some of the others.
    EXPECT_GE(inside / count, .799);
}

INSTANTIATE_TEST_SUITE_P(All, NestedGrids, testing::ValuesIn(rectangles));

TEST(NestedGrid, WithoutAPartIsTheWhole) {
    const NestedGrid grid(rising());
    EXPECT_EQ(grid.pdf(.3, .4), rising().pdf(.3, .4));
    EXPECT_EQ(grid.sample(.3, .4), rising().sample(.3, .4));
}

} // namespace
} // namespace candela
