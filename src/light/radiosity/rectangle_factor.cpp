// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/rectangle_factor.h"

#include "world/lights/shape_arithmetic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace candela::radiosity {

namespace {

/// Of sizes: how far corners may be off, as floats in a turned space are.
constexpr double tolerated = 2e-6;

/// From and to, along each axis.
using Box = std::array<std::array<double, 2>, 3>;

Double3 wayBetween(const Vec3 &from, const Vec3 &to) { return wide(to) - wide(from); }
double arcTangent(double y, double x) { return y == 0 ? 0 : std::atan(y / x); }

/// A part of the integral over two parallel rectangles at that distance: both edges' differences.
double parallelPart(double x, double y, double distance) {
    const double acrossX = std::hypot(x, distance), acrossY = std::hypot(y, distance);
    const double squared = x * x + y * y + distance * distance;
    return y * acrossX * arcTangent(y, acrossX) + x * acrossY * arcTangent(x, acrossY) -
           (distance > 0 ? distance * distance / 2 * std::log(squared) : 0);
}

/// And over two that stand square on each other's planes: places across the line in which these
/// meet, and a difference along it.
double squarePart(double across, double acrossOther, double along) {
    const double s = std::hypot(across, acrossOther);
    const double squared = s * s + along * along;
    return along * s * arcTangent(along, s) -
           (squared > 0 ? (s * s - along * along) / 4 * std::log(squared) : 0);
}

/// Alternating over all ends.
template <class Part> double sumOfParts(const Part &part) {
    double sum = 0;
    for (int k = 0; k < 16; ++k) {
        const bool i = k & 1, j = k & 2, m = k & 4, n = k & 8;
        sum += (i ^ j ^ m ^ n ? -1 : 1) * part(i, j, m, n);
    }
    return std::fabs(sum) / (2 * std::numbers::pi);
}

bool isRectangle(std::span<const Vec3> corners) {
    if (corners.size() != 4)
        return false;
    const Double3 x = wayBetween(corners[0], corners[1]), y = wayBetween(corners[0], corners[3]);
    const Double3 far = wayBetween(corners[0], corners[2]);
    const double size = std::sqrt(dot(far, far));
    const Double3 open = x + y - far;
    const double off = std::max({std::fabs(dot(x, y)) / std::max(size, 1e-300), std::fabs(open.x),
                                 std::fabs(open.y), std::fabs(open.z)});
    return off <= tolerated * size && dot(x, x) > 0 && dot(y, y) > 0;
}

/// What corners span along the axes from an origin; nothing, if an edge leaves these.
std::optional<Box> boxOf(std::span<const Vec3> corners, const Vec3 &origin,
                         const std::array<Double3, 3> &axes, double rounding) {
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<double, 4> at{};
        for (std::size_t k = 0; k < 4; ++k)
            at[k] = dot(wayBetween(origin, corners[k]), axes[axis]);
        const auto [least, most] = std::ranges::minmax(at);
        double low = 0, high = 0;
        int lows = 0;
        for (const double value : at) {
            const bool isLow = value - least <= most - value;
            if (std::min(value - least, most - value) > rounding)
                return std::nullopt;
            (isLow ? low : high) += value;
            lows += isLow;
        }
        if (most - least <= rounding)
            box[axis] = {(low + high) / 4, (low + high) / 4};
        else if (lows == 2)
            box[axis] = {low / 2, high / 2};
        else
            return std::nullopt;
    }
    return box;
}

/// Moved onto the plane at 0 if it is there but for rounding; nothing, if it goes through it.
bool keepToOneSide(std::array<double, 2> &range, double rounding) {
    for (double &end : range)
        if (std::fabs(end) <= rounding)
            end = 0;
    return range[0] * range[1] >= 0;
}

} // namespace

std::optional<double> rectangleFactor(std::span<const Vec3> from, std::span<const Vec3> to) {
    if (!isRectangle(from) || !isRectangle(to))
        return std::nullopt;
    std::array<Double3, 3> axes{wayBetween(from[0], from[1]), wayBetween(from[0], from[3]), {}};
    std::array<double, 2> size{};
    for (const std::size_t k : {0u, 1u}) {
        size[k] = std::sqrt(dot(axes[k], axes[k]));
        axes[k] = {axes[k].x / size[k], axes[k].y / size[k], axes[k].z / size[k]};
    }
    axes[2] = cross(axes[0], axes[1]);
    const Double3 away = wayBetween(from[0], to[0]);
    const double rounding = tolerated * (size[0] + size[1] + std::sqrt(dot(away, away)));
    std::optional<Box> box = boxOf(to, from[0], axes, rounding);
    if (!box)
        return std::nullopt;
    const double area = size[0] * size[1];
    auto &[x, y, z] = *box;
    if (z[0] == z[1]) {
        const double distance = std::fabs(z[0]) <= rounding ? 0 : std::fabs(z[0]);
        if (distance == 0)
            return 0;
        return sumOfParts([&](bool i, bool j, bool m, bool n) {
                   return parallelPart(x[i] - (j ? size[0] : 0), y[m] - (n ? size[1] : 0),
                                       distance);
               }) /
               area;
    }
    const bool isAcrossX = x[0] == x[1];
    if ((!isAcrossX && y[0] != y[1]) || !keepToOneSide(z, rounding))
        return std::nullopt;
    const std::size_t across = isAcrossX ? 0 : 1, along = 1 - across;
    std::array<double, 2> own{-(*box)[across][0], size[across] - (*box)[across][0]};
    if (!keepToOneSide(own, rounding))
        return std::nullopt;
    return sumOfParts([&](bool i, bool j, bool m, bool n) {
               return squarePart(own[i], z[j], (*box)[along][m] - (n ? size[along] : 0));
           }) /
           area;
}

} // namespace candela::radiosity
