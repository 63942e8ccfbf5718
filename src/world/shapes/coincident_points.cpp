// SPDX-License-Identifier: Apache-2.0
#include "world/shapes/coincident_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace candela {

namespace {

/// Coordinates computed in two ways differ by some units of the last digit.
constexpr double rounding = 4 * 0x1p-24;

/// A cell of a grid whose cells are as large as rounding is about there.
using Cell = std::array<std::int64_t, 4>;

struct CellHash {
    std::size_t operator()(const Cell &cell) const {
        std::uint64_t hash = 0;
        for (std::int64_t c : cell)
            hash = (hash ^ std::uint64_t(c)) * 0x9e3779b97f4a7c15u, hash ^= hash >> 29;
        return std::size_t(hash);
    }
};

/// Grids are by powers of two of the largest coordinate.
int gridOf(Vec3 p) {
    const float most = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    return most > 0x1p-100f ? std::ilogb(most) : -100;
}
double cellSize(int grid) { return std::ldexp(4 * rounding, grid); }

Cell cellAt(int grid, double x, double y, double z) {
    const auto number = [&](double c) { return std::int64_t(std::floor(c / cellSize(grid))); };
    return {grid, number(x), number(y), number(z)};
}

} // namespace

std::vector<std::uint32_t> placesOf(std::span<const Vec3> points) {
    std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> known; // First points of places.
    std::vector<std::uint32_t> place;
    place.reserve(points.size());
    std::uint32_t places = 0;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const Vec3 p = points[i];
        const int own = gridOf(p);
        std::uint32_t found = places;
        // What is within half a cell stands in one of eight; across a power of two, of another
        // grid.
        for (int grid = own - 1; grid <= own + 1; ++grid)
            for (int corner = 0; corner < 8; ++corner) {
                const double reach = cellSize(grid) / 2;
                const auto side = [&](float c, int bit) {
                    return corner & bit ? c + reach : c - reach;
                };
                const auto cell =
                    known.find(cellAt(grid, side(p.x, 1), side(p.y, 2), side(p.z, 4)));
                if (cell == known.end())
                    continue;
                for (std::uint32_t first : cell->second)
                    if (length(points[first] - p) <= reach)
                        found = std::min(found, place[first]);
            }
        if (found == places) {
            known[cellAt(own, p.x, p.y, p.z)].push_back(i);
            ++places;
        }
        place.push_back(found);
    }
    return place;
}

} // namespace candela
