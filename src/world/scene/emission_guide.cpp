// SPDX-License-Identifier: Apache-2.0
#include "world/scene/emission_guide.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

/// The lower half of the sphere lies outside the square's diamond, folded over its sides.
std::array<double, 2> folded(double a, double b) { return {1 - b, 1 - a}; }

} // namespace

/// Each octant is the sector of a disc (Lambert), which becomes a triangle of constant measure.
std::array<double, 2> squareOfDirection(Vec3 direction) {
    const double x = std::fabs(double(direction.x)), y = std::fabs(double(direction.y));
    const double r = std::sqrt(std::max(0.0, 1 - std::fabs(double(direction.z))));
    const double turn = std::atan2(y, x) / (std::numbers::pi / 2);
    std::array<double, 2> place{r * (1 - turn), r * turn};
    if (direction.z < 0)
        place = folded(place[0], place[1]);
    return {(1 + std::copysign(place[0], double(direction.x))) / 2,
            (1 + std::copysign(place[1], double(direction.y))) / 2};
}

Vec3 directionOfSquare(double a, double b) {
    const double x = 2 * a - 1, y = 2 * b - 1, u = std::fabs(x), v = std::fabs(y);
    const double inside = 1 - (u + v), r = 1 - std::fabs(inside);
    const double turn = r > 0 ? ((v - u) / r + 1) / 2 * (std::numbers::pi / 2) : 0;
    const double across = r * std::sqrt(std::max(0.0, 2 - r * r));
    return normalize(Vec3{float(std::copysign(across * std::cos(turn), x)),
                          float(std::copysign(across * std::sin(turn), y)),
                          float(std::copysign(1 - r * r, inside))});
}

} // namespace candela
