// SPDX-License-Identifier: Apache-2.0
// Form factors of rectangles (VALIDATION B1, B2, B5, B6).
#include "light/radiosity/rectangle_factor.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace candela::radiosity {
namespace {

using Rectangle = std::array<Vec3, 4>;

Rectangle rectangle(Vec3 corner, Vec3 x, Vec3 y) {
    return {corner, corner + x, corner + x + y, corner + y};
}

double factor(const Rectangle &a, const Rectangle &b) { return rectangleFactor(a, b).value_or(-1); }

double areaOf(const Rectangle &r) {
    const Vec3 x = r[1] - r[0], y = r[3] - r[0];
    return std::sqrt(double(dot(x, x)) * double(dot(y, y)));
}

/// B5: of two rectangles a x b, one over the other at distance 1.
double opposite(double a, double b) {
    const double A = std::sqrt(1 + a * a), B = std::sqrt(1 + b * b);
    return 2 / (std::numbers::pi * a * b) *
           (std::log(A * B / std::sqrt(1 + a * a + b * b)) + a * B * std::atan(a / B) +
            b * A * std::atan(b / A) - a * std::atan(a) - b * std::atan(b));
}

TEST(RectangleFactor, OfPairsThatBooksTell) {
    const Rectangle unit = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const Rectangle wide = rectangle({0, 0, 0}, {2, 0, 0}, {0, 1, 0});
    EXPECT_NEAR(factor(unit, rectangle({0, 0, 1}, {1, 0, 0}, {0, 1, 0})), 0.199824895698387, 1e-12);
    EXPECT_NEAR(factor(unit, rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1})), 0.200043776075403, 1e-12);
    EXPECT_NEAR(factor(wide, rectangle({0, 0, 1}, {0, 1, 0}, {2, 0, 0})), 0.285875384850715, 1e-12);
    for (const float a : {0.125f, 0.5f, 3.0f, 20.0f})
        for (const float b : {0.25f, 1.0f, 8.0f})
            EXPECT_NEAR(factor(rectangle({5, 1, 2}, {a, 0, 0}, {0, b, 0}),
                               rectangle({5, 1, 1}, {a, 0, 0}, {0, b, 0})),
                        opposite(double(a), double(b)), 1e-10)
                << a << " x " << b;
}

/// The walls of a box, cut as one likes: what each part sends, the others get, and A F is the same
/// both ways.
TEST(RectangleFactor, RowsOfABoxSumUpToOneAndPairsAreReciprocal) {
    constexpr int cuts = 4;
    const Vec3 size{2, 1, 4};
    std::vector<Rectangle> parts;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool isFar : {false, true}) {
            Vec3 corner, x, y;
            const int across = (axis + 1) % 3, up = (axis + 2) % 3;
            corner[axis] = isFar ? size[axis] : 0;
            x[across] = size[across] / cuts, y[up] = size[up] / cuts;
            for (int i = 0; i < cuts; ++i)
                for (int j = 0; j < cuts; ++j)
                    parts.push_back(rectangle(corner + x * float(i) + y * float(j), x, y));
        }
    for (const Rectangle &a : parts) {
        double sum = 0;
        for (const Rectangle &b : parts) {
            const double there = factor(a, b);
            sum += there;
            EXPECT_GE(there, 0);
            EXPECT_NEAR(areaOf(a) * there, areaOf(b) * factor(b, a), 1e-9);
        }
        EXPECT_NEAR(sum, 1, 1e-9);
    }
}

/// Corners are floats in whatever space there is; order and turn do not matter.
TEST(RectangleFactor, HoldsInTurnedMirroredTinyAndHugeSpaces) {
    const Vec3 x = normalize(Vec3{1, 2, -0.5f}), z = normalize(cross(x, Vec3{0.3f, -1, 2}));
    const Vec3 y = cross(z, x);
    for (const float scale : {1e-3f, 1.0f, 1e3f})
        for (const float mirror : {1.0f, -1.0f}) {
            const auto at = [&](Vec3 p) {
                return (x * p.x + y * (mirror * p.y) + z * p.z) * scale + Vec3{1, -2, 3} * scale;
            };
            const auto placed = [&](const Rectangle &r, std::size_t first) {
                Rectangle result;
                for (std::size_t k = 0; k < 4; ++k)
                    result[k] = at(r[(first + k) % 4]);
                return result;
            };
            const Rectangle floor = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
            const Rectangle wall = rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1});
            for (std::size_t first = 0; first < 4; ++first)
                EXPECT_NEAR(factor(placed(floor, first), placed(wall, 3 - first)),
                            0.200043776075403, 1e-5)
                    << scale << " " << mirror;
        }
}

TEST(RectangleFactor, IsToldOfNothingElse) {
    const Rectangle floor = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const auto isTold = [&](const Rectangle &a, const Rectangle &b) {
        return rectangleFactor(a, b).has_value();
    };
    EXPECT_EQ(factor(floor, rectangle({1, 0, 0}, {1, 0, 0}, {0, 1, 0})), 0) << "in one plane";
    EXPECT_FALSE(isTold(floor, rectangle({0, 0, -0.5f}, {0, 1, 0}, {0, 0, 1}))) << "through it";
    EXPECT_FALSE(isTold(floor, rectangle({0.5f, 0, 0}, {0, 1, 0}, {0, 0, 1}))) << "standing on it";
    EXPECT_FALSE(isTold(floor, rectangle({0, 0, 1}, {1, 0, 0}, {0, 0.8f, 0.6f}))) << "tilted";
    EXPECT_FALSE(isTold(floor, rectangle({0, 0, 1}, {1, 1, 0}, {-1, 1, 0}))) << "turned";
    EXPECT_FALSE(isTold(floor, rectangle({0, 0, 1}, {1, 0, 0}, {0.5f, 1, 0}))) << "oblique";
    EXPECT_FALSE(isTold(floor, rectangle({0, 0, 1}, {0, 0, 0}, {0, 1, 0}))) << "a line";
    EXPECT_FALSE(rectangleFactor(std::span(floor).first(3), floor)) << "a triangle";
}

} // namespace
} // namespace candela::radiosity
