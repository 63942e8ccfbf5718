// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/curve_section.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

constexpr float fullTurn = 2 * std::numbers::pi_v<float>;

/// The derivative of a unit vector q / |q|, given that of q.
Vec3 turning(Vec3 q, Vec3 unit, Vec3 change) {
    const float size = length(q);
    return size > 0 ? (change - unit * dot(unit, change)) * (1 / size) : Vec3{};
}

Vec3 anyAcross(Vec3 tangent) {
    Vec3 x, y;
    orthonormalBasis(tangent, x, y);
    return x;
}

struct CurvePlace {
    Vec3 P, slope, bend;
};

CurvePlace placeAt(const std::array<CurveOrdinates, 3> &position, float v) {
    CurvePlace place;
    for (int c = 0; c < 3; ++c) {
        const CubicAt at = cubicAt(position[c], v);
        place.P[c] = at.value, place.slope[c] = at.slope, place.bend[c] = at.bend;
    }
    return place;
}

/// How the tangent turns along the segment.
Vec3 turningOf(const CurvePlace &place, Vec3 tangent) {
    return turning(place.slope, tangent, place.bend);
}

} // namespace

CurveSegment between(const CurveSegment &from, const CurveSegment &to, float share) {
    CurveSegment segment;
    for (std::size_t c = 0; c < 3; ++c) {
        segment.position[c] = between(from.position[c], to.position[c], share);
        segment.normal[c] = between(from.normal[c], to.normal[c], share);
    }
    segment.width = between(from.width, to.width, share);
    return segment;
}

Vec3 CurveSegment::at(float v) const { return placeAt(position, v).P; }
Vec3 CurveSegment::slopeAt(float v) const { return placeAt(position, v).slope; }

float CurveSegment::largestSlope() const {
    float largest = 0;
    for (int k = 0; k < 3; ++k) {
        Vec3 leg;
        for (int c = 0; c < 3; ++c)
            leg[c] = 3 * (position[c][k + 1] - position[c][k]);
        largest = std::max(largest, length(leg));
    }
    return largest;
}

Vec3 CurveSegment::tangentAt(float v) const {
    const Vec3 slope = slopeAt(v);
    const float size = length(slope), largest = largestSlope();
    if (size > 1e-4f * largest)
        return slope * (1 / size);
    // Where control points coincide the way to a place beside it tells.
    const Vec3 beside = at(std::min(v + 0.01f, 1.0f)) - at(std::max(v - 0.01f, 0.0f));
    const float way = length(beside);
    return way > 1e-7f * largest ? beside * (1 / way) : Vec3{0, 0, 1};
}

TubeFrame tubeFrame(const CurveSegment &segment, Vec3 axis, float v) {
    const Vec3 tangent = segment.tangentAt(v);
    const Vec3 across = axis - tangent * dot(tangent, axis);
    const float size = length(across);
    const Vec3 x = size > 1e-4f ? across * (1 / size) : anyAcross(tangent);
    return {x, cross(tangent, x), tangent};
}

SectionPoint tubePoint(const CurveSegment &segment, Vec3 axis, float u, float v) {
    const CurvePlace place = placeAt(segment.position, v);
    const TubeFrame frame = tubeFrame(segment, axis, v);
    const CubicAt width = cubicAt(segment.width, v);
    const float radius = width.value / 2, c = std::cos(fullTurn * u), s = std::sin(fullTurn * u);
    const Vec3 outwards = frame.x * c + frame.y * s, around = frame.y * c - frame.x * s;
    const Vec3 turn = turningOf(place, frame.tangent);
    const Vec3 across = axis - frame.tangent * dot(frame.tangent, axis);
    const Vec3 change = -(turn * dot(frame.tangent, axis) + frame.tangent * dot(turn, axis));
    const Vec3 xTurn = turning(across, frame.x, change);
    const Vec3 yTurn = cross(turn, frame.x) + cross(frame.tangent, xTurn);
    SectionPoint point;
    point.P = place.P + outwards * radius;
    point.dPdu = around * (fullTurn * radius);
    point.dPdv = place.slope + outwards * (width.slope / 2) + (xTurn * c + yTurn * s) * radius;
    // Where the tube bends more sharply than it is wide, its inner side runs backwards.
    const Vec3 normal = cross(around, point.dPdv);
    point.Ng = dot(normal, outwards) > 1e-4f * length(point.dPdv) ? normal : outwards;
    return point;
}

SectionPoint ribbonPoint(const CurveSegment &segment, float u, float v) {
    const CurvePlace place = placeAt(segment.position, v), facing = placeAt(segment.normal, v);
    const Vec3 tangent = segment.tangentAt(v);
    const CubicAt width = cubicAt(segment.width, v);
    const Vec3 span = cross(tangent, facing.P);
    const float size = length(span);
    const bool isAcross = size > 1e-4f * length(facing.P);
    const Vec3 across = isAcross ? span * (1 / size) : anyAcross(tangent);
    const Vec3 change = cross(turningOf(place, tangent), facing.P) + cross(tangent, facing.slope);
    const Vec3 turn = isAcross ? turning(span, across, change) : Vec3{};
    SectionPoint point;
    point.P = place.P + across * ((u - 0.5f) * width.value);
    point.dPdu = across * width.value;
    point.dPdv = place.slope + (across * width.slope + turn * width.value) * (u - 0.5f);
    const Vec3 normal = cross(across, point.dPdv);
    point.Ng = length(normal) > 1e-4f * length(point.dPdv) ? normal : cross(across, tangent);
    return point;
}

} // namespace candela
