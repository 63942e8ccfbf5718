// SPDX-License-Identifier: Apache-2.0
// Form factors of points against closed forms (VALIDATION C4, D1), and of all that surrounds a
// point.
#include "light/radiosity/transfer.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::radiosity {
namespace {

constexpr double pi = std::numbers::pi;

/// A square of that side in the plane z = height about (0,0), seen from below; counter-clockwise
/// from above, so that its front, up, is turned away.
std::array<Vec3, 4> square(float side, float height) {
    const float h = side / 2;
    return {Vec3{-h, -h, height}, Vec3{h, -h, height}, Vec3{h, h, height}, Vec3{-h, h, height}};
}

TEST(ContourFactor, OfASquareOverhead) {
    const std::array<double, 6> rows[] = {// x, y, height, E of radiance 1
                                          {0, 0, 1, 0.7522747}, {0.5, 0.5, 1, 0.4352099},
                                          {1, 0, 1, 0.2650049}, {2, 0, 1, 0.0437426},
                                          {0, 0, 2, 0.2308368}, {0, 0, 0.1, 3.0421284}};
    for (const auto &[x, y, height, E, none, nothing] : rows) {
        const auto corners = square(1, float(height));
        const float front =
            contourFactor({float(x), float(y), 0}, {0, 0, 1}, std::span<const Vec3>(corners), -1);
        EXPECT_NEAR(front * pi, E, 2e-6 * std::max(1.0, E)) << x << " " << y << " " << height;
        EXPECT_EQ(
            contourFactor({float(x), float(y), 0}, {0, 0, 1}, std::span<const Vec3>(corners), 1),
            0);
    }
}

/// A wall on the edge of a lit square of 4 m: half of it is above the wall's horizon, its edge lies
/// in it.
TEST(ContourFactor, OnAWallOverAFloor) {
    const std::array<Vec3, 4> floor{Vec3{-2, 0, 0}, Vec3{2, 0, 0}, Vec3{2, 4, 0}, Vec3{-2, 4, 0}};
    const std::pair<float, double> rows[] = {{0.5f, 0.403838}, {1, 0.317550}, {1.5f, 0.246230},
                                             {2, 0.190136},    {3, 0.114496}, {3.5f, 0.089811}};
    for (const auto &[z, factor] : rows)
        EXPECT_NEAR(contourFactor({0, 0, z}, {0, 1, 0}, std::span<const Vec3>(floor), 1), factor,
                    2e-6);
}

/// What surrounds a point fills its hemisphere, wherever it is in the box.
TEST(ContourFactor, OfAllWallsAroundIsOne) {
    const Vec3 p[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                      {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const int faces[6][4] = {{0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1},
                             {3, 2, 6, 7}, {0, 3, 7, 4}, {1, 5, 6, 2}};
    for (const Vec3 P : {Vec3{0.5f, 0.5f, 0.5f}, Vec3{0.01f, 0.3f, 0.9f}, Vec3{0.2f, 0.999f, 0.4f}})
        for (const Vec3 N : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, normalize(Vec3{1, -2, 0.5f})}) {
            double sum = 0;
            for (const auto &face : faces) {
                const std::array<Vec3, 4> corners{p[face[0]], p[face[1]], p[face[2]], p[face[3]]};
                sum += contourFactor(P, N, std::span<const Vec3>(corners), 1);
            }
            EXPECT_NEAR(sum, 1, 3e-6);
        }
}

/// On an edge, in the plane and behind, answers are numbers between 0 and 1.
TEST(ContourFactor, IsANumberWhereItIsSingular) {
    const auto corners = square(1, 0);
    for (const Vec3 P : {Vec3{0.5f, 0, 0}, Vec3{0.5f, 0.5f, 0}, Vec3{0, 0, 0}, Vec3{2, 0, 0}})
        for (const Vec3 N : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, -1}}) {
            const float factor = contourFactor(P, N, std::span<const Vec3>(corners), 1);
            EXPECT_GE(factor, 0);
            EXPECT_LE(factor, 1 + 1e-5f);
        }
}

} // namespace
} // namespace candela::radiosity
