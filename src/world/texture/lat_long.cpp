// SPDX-License-Identifier: Apache-2.0
#include "world/texture/lat_long.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

constexpr double pi = std::numbers::pi;

/// Longitude and latitude change by these where the direction of unit length changes by `by`.
void change(const Vec3 &unit, double across, const Vec3 &by, float &ds, float &dt) {
    const double along = double(unit.x) * by.y - double(unit.y) * by.x;
    ds = float(std::clamp(along / (2 * pi * across * across), -1.0, 1.0));
    const double outward = double(unit.x) * by.x + double(unit.y) * by.y;
    // Of the polar angle, atan(across, z).
    dt = float(std::clamp((unit.z * outward / across - across * by.z) / pi, -1.0, 1.0));
}

} // namespace

PlaceReach latLongPlace(const DirectionReach &reach, int columns) {
    PlaceReach place;
    const double size = std::sqrt(double(dot(reach.direction, reach.direction)));
    if (!(size > 0) || !std::isfinite(size))
        return place;
    const Vec3 unit = reach.direction / float(size);
    const double radius = std::hypot(double(unit.x), double(unit.y));
    const double longitude = radius > 0 ? std::atan2(double(unit.y), double(unit.x)) : 0;
    place.s = float(longitude / (2 * pi));
    place.s -= std::floor(place.s);
    place.t = float(std::atan2(radius, double(unit.z)) / pi);
    const double across = std::max(radius, 1e-6);
    change(unit, across, reach.x / float(size), place.dsdx, place.dtdx);
    change(unit, across, reach.y / float(size), place.dsdy, place.dtdy);
    // Half a pixel at the equator, as seen from the pole.
    const float least = float(std::min(1.0, 0.5 / (std::max(1, columns) * across)));
    const float widest = std::max(std::abs(place.dsdx), std::abs(place.dsdy));
    if (widest < least && across < 0.5)
        (std::abs(place.dsdx) >= std::abs(place.dsdy) ? place.dsdx : place.dsdy) = least;
    return place;
}

Vec3 latLongDirection(float s, float t) {
    const double longitude = 2 * pi * s, polar = pi * t;
    return {float(std::cos(longitude) * std::sin(polar)),
            float(std::sin(longitude) * std::sin(polar)), float(std::cos(polar))};
}

} // namespace candela
