// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/subdivision_cells.h"

#include <algorithm>

namespace candela {

SubdivisionCells::SubdivisionCells(const SubdivisionTree &tree, const SubdivisionErrors &errors,
                                   std::uint32_t piece, const SubdivisionRate &rate)
    : tree_(tree), errors_(errors), piece_(piece), rate_(rate) {
    rate_.mostLevels = std::min(rate_.mostLevels, mostLevels);
    cut(tree.root(piece), {piece, 0, 0, 0});
}

void SubdivisionCells::cut(std::int32_t square, const SubdivisionLeaf &where) {
    if (square < 0) {
        const std::uint32_t number = std::uint32_t(-1 - square);
        const int levels = errors_.levels(where, number, rate_), parts = 1 << levels;
        chord_ = std::max(chord_, errors_.ofLeaf(number, levels).chord);
        for (int v = 0; v < parts; ++v)
            for (int u = 0; u < parts; ++u)
                add({piece_, where.depth + levels, where.u * parts + u, where.v * parts + v});
        return;
    }
    const SubdivisionErrors::Bounds bounds = errors_.ofNode(square);
    if (errors_.isFine(bounds, rate_) || where.depth >= rate_.mostLevels) {
        chord_ = std::max(chord_, bounds.chord);
        return add(where);
    }
    for (int up : {0, 1})
        for (int right : {0, 1})
            cut(tree_.child(square, right, up),
                {piece_, where.depth + 1, 2 * where.u + right, 2 * where.v + up});
}

void SubdivisionCells::add(const SubdivisionLeaf &where) {
    const int side = units >> where.depth;
    const Cell cell{where.u * side, where.v * side, side};
    const bool isAlong[4] = {cell.v == 0, cell.v + side == units, cell.u == 0,
                             cell.u + side == units};
    for (int k = 0; k < 4; ++k)
        if (isAlong[k])
            along_[k] = std::max(along_[k], where.depth);
    cells_.push_back(cell);
}

int SubdivisionCells::sideAt(Place place) const {
    std::int32_t square = tree_.root(piece_);
    int depth = 0;
    while (square >= 0 && depth < rate_.mostLevels &&
           !errors_.isFine(errors_.ofNode(square), rate_)) {
        const int shift = mostLevels - depth;
        square = tree_.child(square, place.u >> shift & 1, place.v >> shift & 1);
        ++depth;
    }
    if (square < 0) {
        const SubdivisionLeaf where{piece_, depth, 0, 0};
        depth += errors_.levels(where, std::uint32_t(-1 - square), rate_);
    }
    return units >> depth;
}

bool SubdivisionCells::isCut(Place from, Place to, int length, int side,
                             const std::array<int, 4> &levels) const {
    const int across = side < 2 ? from.v : from.u;
    if (across == 0 || across == units)
        return length > units >> levels[side];
    // Beyond the line, beside its middle: smaller cells meet there.
    const int along = side < 2 ? (from.u + to.u) / 2 : (from.v + to.v) / 2;
    const int beyond = side == 0 || side == 2 ? across - 1 : across;
    return sideAt(side < 2 ? Place{along, beyond} : Place{beyond, along}) < length;
}

} // namespace candela
