// SPDX-License-Identifier: Apache-2.0
// Which vertices of displaced shapes are one point.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// A vertex of a shape, and the number of its place (placesOf()).
struct PlacedVertex {
    std::uint32_t shape, place;
};

/// For each vertex the number of its point; points are numbered by their first vertices. Vertices
/// of one place are one point, so that rims close, unless their shapes lie in each other's place
/// with more than a rim: bodies of one form, which move apart. `triangles`: all of them, of
/// vertices of one shape each.
std::vector<std::uint32_t> joinedPoints(std::span<const PlacedVertex>,
                                        std::span<const std::array<std::uint32_t, 3>> triangles);

} // namespace candela
