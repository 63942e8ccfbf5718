// SPDX-License-Identifier: Apache-2.0
// The triangles of a patch mesh.
#pragma once

#include "world/geometry/dice_counts.h"
#include "world/geometry/patch_polynomials.h"

#include <span>

namespace candela {

/// Into how many cells each column and each row of patches is cut: neighbours agree along the edge
/// that they share.
struct PatchCuts {
    std::vector<int> columns, rows;
    double error = 0; ///< cellError of the worst patch.
};

/// `bounds` of each patch, by its own parameters.
PatchCuts choosePatchCuts(const PatchGrid &, std::span<const DerivativeBounds> bounds,
                          const DiceRate &);

/// Positions come from evaluate(). If the patches meet, neighbours share their vertices, and the
/// ends of a periodic mesh theirs where they are within `tolerance`; under a basis whose patches do
/// not meet each is diced for itself. chordError is left to the caller.
DicedMesh dicePatches(const PatchGrid &, const PatchCuts &, const Surface &, bool patchesMeet,
                      float tolerance);

} // namespace candela
