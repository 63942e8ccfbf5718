// SPDX-License-Identifier: Apache-2.0
// Subdivision meshes refined until their limit surface is bicubic patches.
#pragma once

#include "interface/ri/primitive_record.h"
#include "world/geometry/patch_polynomials.h"
#include "world/geometry/subdivision_tree.h"

#include <memory>
#include <span>
#include <string>

namespace candela {

/// One side of a piece, as it runs along its u or v: part of an edge, from share to share of it. An
/// edge runs from its vertex of the lower number, a spoke from the middle of its edge.
struct SubdivisionSide {
    std::uint32_t edge = 0;       ///< Of the mesh; spokes are counted after all edges.
    int fromHalf = 0, toHalf = 2; ///< 0, 1, 2: the beginning, the middle, the end.
};

/// A face of four corners is a piece; others have one at each corner, from that corner over the
/// middles of its edges to the middle of the face.
struct SubdivisionPiece {
    std::uint32_t face = 0;
    int corner = -1; ///< Of the face; -1: the piece is the face.
    /// v = 0 and v = 1 along u; u = 0 and u = 1 along v.
    std::array<SubdivisionSide, 4> sides;
};

/// What the mesh's edges and spokes end at.
struct SubdivisionEdges {
    std::uint32_t vertices = 0, faces = 0;
    std::vector<std::array<std::uint32_t, 2>> edges; ///< Vertices, the lower number first.
    struct Spoke {
        std::uint32_t edge, face;
    };
    std::vector<Spoke> spokes;
};

class SubdivisionRefinement {
public:
    /// Null, and a sentence, if the mesh is no surface. The record's numbers must be within bounds.
    static std::unique_ptr<SubdivisionRefinement> of(const SubdivisionRecord &, int vertices,
                                                     std::string &why);
    virtual ~SubdivisionRefinement() = default;

    /// All pieces, those that are holes too: the tree has no leaves there.
    const std::vector<SubdivisionPiece> &pieces() const { return pieces_; }
    const SubdivisionEdges &edges() const { return edges_; }
    const SubdivisionTree &tree() const { return tree_; }
    /// Creases along what is no edge, which have no effect.
    int strayCreases() const { return strayCreases_; }
    /// Values at vertices, `components` floats each, as polynomials of the tree's leaves.
    virtual PatchPolynomials convert(std::span<const float> values, int components) const = 0;

protected:
    std::vector<SubdivisionPiece> pieces_;
    SubdivisionEdges edges_;
    SubdivisionTree tree_;
    int strayCreases_ = 0;
};

} // namespace candela
