// SPDX-License-Identifier: Apache-2.0
#include "light/probe/placed_points.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

using Triple = std::array<double, 3>;

Triple pointBy(const Matrix4d &m, const Triple &p) {
    Triple result{};
    for (int c = 0; c < 3; ++c)
        result[c] = p[0] * m.at(0, c) + p[1] * m.at(1, c) + p[2] * m.at(2, c) + m.at(3, c);
    return result;
}

Triple directionBy(const Matrix4d &m, const Triple &d) {
    Triple result{};
    for (int c = 0; c < 3; ++c)
        result[c] = d[0] * m.at(0, c) + d[1] * m.at(1, c) + d[2] * m.at(2, c);
    return result;
}

Triple normalBy(const Matrix4d &inverse, const Triple &n) {
    Triple result{};
    for (int c = 0; c < 3; ++c)
        result[c] = n[0] * inverse.at(c, 0) + n[1] * inverse.at(c, 1) + n[2] * inverse.at(c, 2);
    return result;
}

/// The unit vector along what may be very long or very short.
Vec3 unitOf(const Triple &v) {
    const double largest = std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
    const Triple s{v[0] / largest, v[1] / largest, v[2] / largest};
    const double length = std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
    return {float(s[0] / length), float(s[1] / length), float(s[2] / length)};
}

/// Four times what rays that leave a surface clear of its own rounding (docs/ray-offset.md): the
/// surface that a sensor lies on has edges that nobody knows here.
float offsetOf(Vec3 P) {
    constexpr float units = 64 * 0x1p-24f;
    return units * std::max({std::fabs(P.x), std::fabs(P.y), std::fabs(P.z)});
}

} // namespace

PlacedPoint place(const ProbePoint &point, const Scene &scene, const ProbeSettings &settings) {
    const Matrix4d &currentFromWorld = scene.options().camera.exactCameraFromWorld;
    const Triple P = pointBy(currentFromWorld, point.P);
    PlacedPoint placed{{float(P[0]), float(P[1]), float(P[2])}, {}, {}, point.number};
    if (settings.quantity == ProbeQuantity::Radiance) {
        placed.aim = unitOf(directionBy(currentFromWorld, point.direction));
        placed.origin = placed.P;
        return placed;
    }
    const Matrix4d worldFromCurrent = inverse(currentFromWorld).value_or(Matrix4d{});
    placed.aim = unitOf(normalBy(worldFromCurrent, point.direction));
    const float offset = settings.offset.value_or(offsetOf(placed.P));
    placed.origin = placed.P + placed.aim * offset;
    return placed;
}

} // namespace candela
