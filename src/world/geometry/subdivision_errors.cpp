// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/subdivision_errors.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// A function of a piece's (u,v) that is affine.
struct AffineMap {
    Vec3 middle, alongU, alongV;
    double middleU = 0, middleV = 0;

    Vec3 at(double u, double v) const {
        return middle + alongU * float(u - middleU) + alongV * float(v - middleV);
    }
};

/// A part of a piece that holds several leaves. If no point of the surface is farther than e from
/// an affine map's of the same name, neither is one of a triangle with its corners on the surface:
/// the two are no farther than 2 e from each other. On each leaf the distance from the map is a
/// polynomial, too, whose Bezier ordinates bound it.
class NodeBounds {
public:
    NodeBounds(const SubdivisionTree &tree, const PatchPositions &positions)
        : tree_(tree), positions_(positions) {}

    double chordOf(const SubdivisionLeaf &square, std::span<const std::uint32_t> leaves) const {
        const AffineMap map = mapOf(square);
        double farthest = 0;
        for (std::uint32_t leaf : leaves)
            farthest = std::max(farthest, distanceOf(leaf, map));
        return 2 * farthest;
    }

private:
    double distanceOf(std::uint32_t number, const AffineMap &map) const {
        const SubdivisionLeaf &leaf = tree_.leaves()[number];
        std::vector<BezierNet> nets;
        for (int c = 0; c < 3; ++c)
            nets.push_back(bezierNet(positions_.polynomials(), int(number), c));
        double farthest = 0;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
                const Vec3 ordinate{float(nets[0].at(i, j)), float(nets[1].at(i, j)),
                                    float(nets[2].at(i, j))};
                const double u = (leaf.u + i / 3.0) * leaf.side();
                const double v = (leaf.v + j / 3.0) * leaf.side();
                farthest = std::max(farthest, double(length(ordinate - map.at(u, v))));
            }
        return farthest;
    }

    AffineMap mapOf(const SubdivisionLeaf &square) const {
        const double side = square.side();
        Vec3 corner[4];
        for (int k = 0; k < 4; ++k)
            corner[k] = pointAt(square.piece, float((square.u + k % 2) * side),
                                float((square.v + k / 2) * side));
        return {(corner[0] + corner[1] + corner[2] + corner[3]) / 4.0f,
                (corner[1] + corner[3] - corner[0] - corner[2]) / float(2 * side),
                (corner[2] + corner[3] - corner[0] - corner[1]) / float(2 * side),
                (square.u + 0.5) * side, (square.v + 0.5) * side};
    }

    Vec3 pointAt(std::uint32_t piece, float u, float v) const {
        const std::uint32_t number = tree_.leafAt(piece, u, v);
        const SubdivisionLeaf &leaf = tree_.leaves()[number];
        const float scale = float(1 << leaf.depth);
        return positions_.pointAt(
            {int(number), u * scale - float(leaf.u), v * scale - float(leaf.v)});
    }

    const SubdivisionTree &tree_;
    const PatchPositions &positions_;
};

} // namespace

SubdivisionErrors::SubdivisionErrors(const SubdivisionTree &tree, const PatchPositions &positions,
                                     std::span<const PatchBounds> bounds)
    : nodes_(tree.nodes()) {
    for (const PatchBounds &leaf : bounds)
        leaves_.push_back({cellError(leaf.derivatives, {1, 1}),
                           2 * std::max(leaf.derivatives.du, leaf.derivatives.dv)});
    const NodeBounds nodeBounds(tree, positions);
    tree.forEachNode([&](std::int32_t node, const SubdivisionLeaf &square,
                         std::span<const std::uint32_t> leaves) {
        nodes_[node].chord = nodeBounds.chordOf(square, leaves);
        for (std::uint32_t leaf : leaves) {
            const double cells = square.side() / tree.leaves()[leaf].side();
            nodes_[node].edge = std::max(nodes_[node].edge, leaves_[leaf].edge * cells);
        }
    });
}

SubdivisionErrors::Bounds SubdivisionErrors::ofLeaf(std::uint32_t leaf, int levels) const {
    return {std::ldexp(leaves_[leaf].chord, -2 * levels), std::ldexp(leaves_[leaf].edge, -levels)};
}

int SubdivisionErrors::levels(const SubdivisionLeaf &leaf, std::uint32_t number,
                              const SubdivisionRate &rate) const {
    int levels = 0;
    while (leaf.depth + levels < rate.mostLevels && !isFine(ofLeaf(number, levels), rate))
        ++levels;
    return levels;
}

} // namespace candela
