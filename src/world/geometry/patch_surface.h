// SPDX-License-Identifier: Apache-2.0
// Meshes of polynomial and rational patches: patches and patch meshes (RI 3.2, 5.2), NURBS (5.2).
#pragma once

#include "world/geometry/grid_variables.h"
#include "world/geometry/patch_dicing.h"
#include "world/geometry/patch_positions.h"

namespace candela {

/// A query's piece is 0 and its (u,v) run from 0 to 1 over the whole mesh; they are RI's, but for
/// NURBS, whose (u,v) run over the range of their knots. Where an edge has collapsed to a point,
/// dPdu, dPdv and Ng are those of a place just beside it.
class PatchSurface final : public Surface {
public:
    /// `positions` have 3 components, or 4 homogeneous ones; `bounds` are those of each patch.
    /// `sides` of the mesh may be empty.
    PatchSurface(const PatchGrid &, PatchPolynomials positions, std::vector<PatchBounds> bounds,
                 MeshSides sides, GridVariables);

    /// False if every normal vanishes.
    bool hasArea() const;
    /// Bounds of the derivatives by the query's u and v.
    std::array<double, 2> longestDerivatives() const;

    Box3 bound() const override { return bound_; }
    DicedMesh dice(const DiceRate &) const override;
    double triangleCount(const DiceRate &) const override;
    /// By Gauss quadrature of |dPdu x dPdv| with 8 x 8 points a patch.
    float area() const override;
    void evaluate(const SurfaceQuery &, const SurfaceAnswer &) const override;
    bool hasOwnNormals() const override { return variables_.hasNormals(); }
    std::span<const VariableInfo> variables() const override { return variables_.infos(); }
    void evaluateVariable(int index, const SurfaceQuery &, float *const *value,
                          float *const *valueDu, float *const *valueDv) const override;

private:
    PatchCuts cutsAt(const DiceRate &) const;

    PatchGrid grid_;
    PatchPositions positions_;
    std::vector<PatchBounds> patchBounds_;
    PatchOutline outline_;
    GridVariables variables_;
    Box3 bound_;
    double roundingError_ = 0; ///< Of evaluate(), in object units.
};

} // namespace candela
