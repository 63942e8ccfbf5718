// SPDX-License-Identifier: Apache-2.0
// Pieces of a subdivision surface, each a unit square, cut into patches the smaller the nearer they
// are to where the surface is not regular.
#pragma once

#include "world/geometry/patch_grid.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace candela {

/// A patch: the square of side 2^-depth whose first corner is at (u,v) 2^-depth.
struct SubdivisionLeaf {
    std::uint32_t piece = 0;
    int depth = 0, u = 0, v = 0;

    double side() const { return 1.0 / (1 << depth); }
};

class SubdivisionTree {
public:
    SubdivisionTree() = default;
    /// Leaves in the order of their pieces, of which there are so many; they cover each piece that
    /// has any.
    SubdivisionTree(std::vector<SubdivisionLeaf>, std::uint32_t pieces);

    const std::vector<SubdivisionLeaf> &leaves() const { return leaves_; }
    bool has(std::uint32_t piece) const { return firstLeaf_[piece] < firstLeaf_[piece + 1]; }
    /// The number of the piece's first leaf; its last stands before that of the next piece.
    std::uint32_t firstLeaf(std::uint32_t piece) const { return firstLeaf_[piece]; }
    /// Up to PatchPoints::capacity places on pieces; the patches are leaves.
    void locate(int count, const std::uint32_t *piece, const float *u, const float *v,
                PatchPoints &) const;
    std::uint32_t leafAt(std::uint32_t piece, float u, float v) const;

    /// Squares that are cut into four are nodes. What a square is: below 0 the leaf -1 - square,
    /// else a node.
    std::size_t nodes() const { return nodes_.size(); }
    std::int32_t root(std::uint32_t piece) const { return roots_[piece]; }
    std::int32_t child(std::int32_t node, int right, int up) const {
        return nodes_[node][up * 2 + right];
    }
    /// Of every node: its number, its square and the leaves within.
    using OfNode = std::function<void(std::int32_t node, const SubdivisionLeaf &square,
                                      std::span<const std::uint32_t> leaves)>;
    void forEachNode(const OfNode &) const;

private:
    void visit(std::int32_t square, const SubdivisionLeaf &where,
               std::vector<std::uint32_t> &leaves, const OfNode &) const;

    std::vector<SubdivisionLeaf> leaves_;
    std::vector<std::uint32_t> firstLeaf_;
    std::vector<std::int32_t> roots_; ///< Squares, of pieces that have leaves.
    std::vector<std::array<std::int32_t, 4>> nodes_;
};

} // namespace candela
