// SPDX-License-Identifier: Apache-2.0
// The triangles of a patch mesh.
#pragma once

#include "world/geometry/bezier_net.h"
#include "world/geometry/side_curve.h"

#include <span>

namespace candela {

/// Into how many cells each column and each row of patches is cut: neighbours agree along the edge
/// that they share.
struct PatchCuts {
    std::vector<int> columns, rows;
    double error = 0; ///< cellError of the worst patch.
};

/// What dicing knows of the mesh besides its cuts.
struct PatchOutline {
    std::span<const PatchBounds> patches;
    MeshSides sides; ///< Empty: the sides are as evaluate() has them.
    bool patchesMeet = true;
    float tolerance = 0; ///< Places this near to one another are the same.
};

/// Triangles of a mesh with these cuts: two a cell, but one where a side of a patch is a point.
double triangleCount(const PatchGrid &, const PatchCuts &, std::span<const PatchBounds>);

PatchCuts choosePatchCuts(const PatchGrid &, std::span<const PatchBounds>, const DiceRate &);

/// Positions come from evaluate(), at the border of the mesh from its sides' own curves. If the
/// patches meet, neighbours share their vertices, and ends of the mesh that meet theirs; under a
/// basis whose patches do not meet each is diced for itself. chordError is left to the caller.
DicedMesh dicePatches(const PatchGrid &, const PatchCuts &, const Surface &, const PatchOutline &);

} // namespace candela
