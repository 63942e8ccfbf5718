// SPDX-License-Identifier: Apache-2.0
// The triangles of subdivision surfaces. Pieces are cut as finely as each place needs it; along an
// edge both sides are cut as the finest cell there is, so that nothing cracks.
#pragma once

#include "world/geometry/subdivision_cells.h"
#include "world/geometry/subdivision_refinement.h"

namespace candela {

/// What is diced: the pieces that are there, in the order in which the surface names them.
struct SubdivisionShape {
    std::vector<SubdivisionPiece> pieces;
    std::vector<std::uint32_t> numbers; ///< Of each, in the tree.
    SubdivisionEdges edges;
    std::shared_ptr<const SubdivisionTree> tree;
    SubdivisionErrors errors;
};

struct SubdivisionCuts {
    std::vector<SubdivisionCells> pieces;
    /// Edges and spokes, as SubdivisionSide counts them, are cut into 2^level parts.
    std::vector<int> edges;
    double error = 0; ///< SubdivisionCells::chord of the worst piece.
};

SubdivisionCuts chooseCuts(const SubdivisionShape &, const DiceRate &);
double triangleCount(const SubdivisionShape &, const SubdivisionCuts &);
/// Positions come from evaluate(); what lies on an edge is where the first piece there says.
/// chordError is left to the caller.
DicedMesh diceSubdivision(const SubdivisionShape &, const SubdivisionCuts &, const Surface &);

} // namespace candela
