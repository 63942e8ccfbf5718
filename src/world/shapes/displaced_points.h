// SPDX-License-Identifier: Apache-2.0
// The vertices of displaced shapes, and the points that they share where shapes meet. Private to
// displaced dicing.
#pragma once

#include "world/shapes/displaced_dicing.h"

#include <cstdint>

namespace candela {

/// A point as one surface names it.
struct DisplacedVertex {
    std::uint32_t shape, piece, point;
    float u, v;
    bool uIsIdle = false, vIsIdle = false; ///< At poles: that coordinate moves nothing.
};

/// What is one point on all surfaces that meet there.
struct DisplacedPoint {
    Vec3 start, moved; ///< Outer space.
    float edge;        ///< As DisplacedDicing has it.
};

/// Vertices, or points, of a triangle, or of an edge in increasing order.
using VertexTriple = std::array<std::uint32_t, 3>;
constexpr std::uint64_t pairOf(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}
constexpr std::uint32_t firstOf(std::uint64_t pair) { return std::uint32_t(pair >> 32); }
constexpr std::uint32_t secondOf(std::uint64_t pair) { return std::uint32_t(pair); }

struct DisplacedPoints {
    std::vector<DisplacedVertex> vertices;
    std::vector<DisplacedPoint> points;

    /// Takes the vertices that the shapes begin with, moves them and returns their triangles.
    std::vector<VertexTriple> begin(std::span<const DisplacedDicing>);
    /// Asks where the vertices from that one on go, and moves the points from that one on, which
    /// are theirs alone, to the mean of it.
    void move(std::span<const DisplacedDicing>, std::uint32_t firstVertex,
              std::uint32_t firstPoint);

    /// The vertex in the middle of an edge of vertices, as that point.
    DisplacedVertex between(std::uint64_t edge, std::uint32_t point) const;
    /// Adds the point in the middle of an edge of points; it is not moved yet.
    std::uint32_t addBetween(std::uint64_t edge);
    float distance(std::uint32_t vertex, std::uint32_t other) const;
    /// Triangles at a pole get vertices of their own there, in the middle of the idle coordinate.
    void turnPoles(std::vector<VertexTriple> &);
};

} // namespace candela
