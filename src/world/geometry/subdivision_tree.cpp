// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/subdivision_tree.h"

#include <algorithm>
#include <limits>

namespace candela {

/// No square yet.
static constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();

SubdivisionTree::SubdivisionTree(std::vector<SubdivisionLeaf> leaves, std::uint32_t pieces)
    : leaves_(std::move(leaves)), firstLeaf_(pieces + 1, 0), roots_(pieces, none) {
    for (const SubdivisionLeaf &leaf : leaves_)
        ++firstLeaf_[leaf.piece + 1];
    for (std::uint32_t piece = 0; piece < pieces; ++piece)
        firstLeaf_[piece + 1] += firstLeaf_[piece];
    for (std::size_t k = 0; k < leaves_.size(); ++k) {
        const SubdivisionLeaf &leaf = leaves_[k];
        // The place of the square at each level, whose node is made where there is none yet.
        std::int32_t parent = none;
        for (int level = 0; level <= leaf.depth; ++level) {
            const int shift = leaf.depth - level;
            std::int32_t &square =
                level == 0 ? roots_[leaf.piece]
                           : nodes_[parent][(leaf.v >> shift & 1) * 2 + (leaf.u >> shift & 1)];
            if (level == leaf.depth) {
                square = -1 - std::int32_t(k);
            } else if (square == none) {
                parent = square = std::int32_t(nodes_.size());
                nodes_.push_back({none, none, none, none});
            } else {
                parent = square;
            }
        }
    }
}

std::uint32_t SubdivisionTree::leafAt(std::uint32_t piece, float u, float v) const {
    std::int32_t square = roots_[piece];
    while (square >= 0) {
        u *= 2, v *= 2;
        const int right = u >= 1, up = v >= 1;
        u -= float(right), v -= float(up);
        square = child(square, right, up);
    }
    return std::uint32_t(-1 - square);
}

void SubdivisionTree::forEachNode(const OfNode &call) const {
    for (std::uint32_t piece = 0; piece < roots_.size(); ++piece)
        if (has(piece)) {
            std::vector<std::uint32_t> leaves;
            visit(roots_[piece], {piece, 0, 0, 0}, leaves, call);
        }
}

void SubdivisionTree::visit(std::int32_t square, const SubdivisionLeaf &where,
                            std::vector<std::uint32_t> &leaves, const OfNode &call) const {
    if (square < 0)
        return leaves.push_back(std::uint32_t(-1 - square));
    const std::size_t first = leaves.size();
    for (int up : {0, 1})
        for (int right : {0, 1})
            visit(child(square, right, up),
                  {where.piece, where.depth + 1, 2 * where.u + right, 2 * where.v + up}, leaves,
                  call);
    call(square, where, std::span(leaves).subspan(first));
}

void SubdivisionTree::locate(int count, const std::uint32_t *piece, const float *u, const float *v,
                             PatchPoints &points) const {
    points.count = count;
    points.meshSpeedU = points.meshSpeedV = 1;
    for (int k = 0; k < count; ++k) {
        // The comparison order sends NaN to 0.
        const float pieceU = u[k] > 0 ? std::min(u[k], 1.0f) : 0.0f;
        const float pieceV = v[k] > 0 ? std::min(v[k], 1.0f) : 0.0f;
        const std::uint32_t number = leafAt(piece[k], pieceU, pieceV);
        const SubdivisionLeaf &leaf = leaves_[number];
        const float scale = float(1 << leaf.depth);
        points.patch[k] = int(number);
        points.u[k] = std::clamp(pieceU * scale - float(leaf.u), 0.0f, 1.0f);
        points.v[k] = std::clamp(pieceV * scale - float(leaf.v), 0.0f, 1.0f);
        points.speedU[k] = points.speedV[k] = scale;
        points.meshU[k] = pieceU, points.meshV[k] = pieceV;
    }
}

} // namespace candela
