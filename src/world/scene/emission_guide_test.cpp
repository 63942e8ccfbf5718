// SPDX-License-Identifier: Apache-2.0
#include "world/scene/emission_guide.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela {
namespace {

constexpr int side = 300;

TEST(SquareOfDirection, isUndoneByItsInverse) {
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const double a = (i + .5) / side, b = (k + .5) / side;
            const Vec3 direction = directionOfSquare(a, b);
            EXPECT_NEAR(length(direction), 1, 1e-6);
            const auto [backA, backB] = squareOfDirection(direction);
            EXPECT_NEAR(backA, a, 1e-5);
            EXPECT_NEAR(backB, b, 1e-5);
        }
}

TEST(SquareOfDirection, keepsAreas) {
    // Whoever spreads places evenly over the square spreads directions evenly over the sphere: the
    // means of all products of coordinates up to the fourth power are the sphere's.
    double x = 0, xx = 0, xy = 0, zz = 0, zzzz = 0, xxyy = 0;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const Vec3 d = directionOfSquare((i + .5) / side, (k + .5) / side);
            x += d.x, xx += double(d.x) * d.x, xy += double(d.x) * d.y, zz += double(d.z) * d.z;
            zzzz += std::pow(d.z, 4), xxyy += std::pow(d.x * d.y, 2);
        }
    constexpr double count = double(side) * side;
    EXPECT_NEAR(x / count, 0, 1e-4);
    EXPECT_NEAR(xx / count, 1. / 3, 1e-4);
    EXPECT_NEAR(xy / count, 0, 1e-4);
    EXPECT_NEAR(zz / count, 1. / 3, 1e-4);
    EXPECT_NEAR(zzzz / count, 1. / 5, 1e-4);
    EXPECT_NEAR(xxyy / count, 1. / 15, 1e-4);
}

TEST(SquareOfDirection, hasPlacesForThePoles) {
    for (const Vec3 direction : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{0, -1, 0}}) {
        const auto [a, b] = squareOfDirection(direction);
        EXPECT_NEAR(length(directionOfSquare(a, b) - direction), 0, 1e-5);
    }
}

} // namespace
} // namespace candela
