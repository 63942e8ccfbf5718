// SPDX-License-Identifier: Apache-2.0
// One piece of a subdivision surface, cut into square cells: small ones where it is not regular.
#pragma once

#include "world/geometry/subdivision_errors.h"

namespace candela {

/// Coordinates are whole numbers from 0 to `units` over the piece; cells have even ones.
class SubdivisionCells {
public:
    static constexpr int mostLevels = 10;
    static constexpr int units = 2 << mostLevels;
    struct Cell {
        int u, v, side;
    };

    SubdivisionCells(const SubdivisionTree &, const SubdivisionErrors &, std::uint32_t piece,
                     const SubdivisionRate &);

    const std::vector<Cell> &cells() const { return cells_; }
    /// What is known of the worst cell.
    double chord() const { return chord_; }
    /// The finest level along a side of the piece: v = 0, v = 1, u = 0, u = 1.
    int levelAlong(int side) const { return along_[side]; }

    /// Calls for each point of the cell's border, once round from its first corner: along v = 0, up
    /// u = 1, back and down. Neighbours' corners are among them, and on the piece's sides the
    /// points of cuts into 2^level parts.
    template <class Call>
    void goRound(const Cell &cell, const std::array<int, 4> &levels, Call call) const {
        const int u1 = cell.u + cell.side, v1 = cell.v + cell.side;
        go({cell.u, cell.v}, {u1, cell.v}, 0, levels, call);
        go({u1, cell.v}, {u1, v1}, 3, levels, call);
        go({u1, v1}, {cell.u, v1}, 1, levels, call);
        go({cell.u, v1}, {cell.u, cell.v}, 2, levels, call);
    }

private:
    struct Place {
        int u, v;
    };
    void cut(std::int32_t square, const SubdivisionLeaf &where);
    void add(const SubdivisionLeaf &where);
    /// The side of the cell that holds the unit square at the place.
    int sideAt(Place) const;

    /// From one corner to before the next; the cell lies on the other side of `side`.
    template <class Call>
    void go(Place from, Place to, int side, const std::array<int, 4> &levels, Call &call) const {
        const int length = std::abs(to.u - from.u) + std::abs(to.v - from.v);
        if (isCut(from, to, length, side, levels)) {
            const Place middle{(from.u + to.u) / 2, (from.v + to.v) / 2};
            go(from, middle, side, levels, call);
            go(middle, to, side, levels, call);
        } else {
            call(from.u, from.v);
        }
    }
    bool isCut(Place from, Place to, int length, int side, const std::array<int, 4> &levels) const;

    const SubdivisionTree &tree_;
    const SubdivisionErrors &errors_;
    std::uint32_t piece_;
    SubdivisionRate rate_;
    std::vector<Cell> cells_;
    double chord_ = 0;
    int along_[4] = {0, 0, 0, 0};
};

} // namespace candela
