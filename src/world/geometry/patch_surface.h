// SPDX-License-Identifier: Apache-2.0
// Patches and patch meshes (RI 3.2, 5.2), bilinear and bicubic, polynomial and rational.
#pragma once

#include "world/geometry/grid_variables.h"
#include "world/geometry/patch_basis.h"
#include "world/geometry/patch_dicing.h"

namespace candela {

/// A query's piece is 0 and its (u,v) are RI's, from 0 to 1 over the whole mesh. Where an edge has
/// collapsed to a point, dPdu, dPdv and Ng are those of a place just beside it.
class PatchSurface final : public Surface {
public:
    /// `positions` have 3 components, or 4 homogeneous ones; `bounds` are those of each patch.
    /// `sides` of the mesh may be empty.
    PatchSurface(const PatchTopology &, PatchPolynomials positions, std::vector<PatchBounds> bounds,
                 std::array<std::vector<SideCurve>, 4> sides, GridVariables);

    /// False if every normal vanishes.
    bool hasArea() const;

    Box3 bound() const override { return bound_; }
    DicedMesh dice(const DiceRate &) const override;
    double triangleCount(const DiceRate &) const override;
    /// By Gauss quadrature of |dPdu x dPdv| with 8 x 8 points a patch.
    float area() const override;
    void evaluate(const SurfaceQuery &, const SurfaceAnswer &) const override;
    std::span<const VariableInfo> variables() const override { return variables_.infos(); }
    void evaluateVariable(int index, const SurfaceQuery &, float *const *value,
                          float *const *valueDu, float *const *valueDv) const override;

private:
    struct Local {
        Vec3 P, du, dv; ///< Derivatives by (u,v) of the mesh.
    };
    template <int degree, bool rational> Local local(int patch, float u, float v) const;
    template <int degree, bool rational>
    void evaluateAs(const SurfaceQuery &, const SurfaceAnswer &) const;
    /// The place that stands for (u,v), moved to just beside where there is no normal.
    template <int degree, bool rational> Vec3 beside(int patch, float &u, float &v, Local &) const;
    /// Derivatives of the unit normal by the mesh's (u,v).
    template <int degree, bool rational>
    std::array<Vec3, 2> normalDerivatives(int patch, float u, float v, const Local &) const;
    PatchCuts cutsAt(const DiceRate &) const;
    Vec3 normalAt(int patch, float u, float v) const;

    PatchTopology topology_;
    PatchPolynomials positions_;
    std::vector<PatchBounds> patchBounds_;
    PatchOutline outline_;
    std::vector<float> leastNormal_; ///< Of each patch: |dPdu x dPdv| below this is degenerate.
    GridVariables variables_;
    Box3 bound_;
    double roundingError_ = 0; ///< Of evaluate(), in object units.
};

} // namespace candela
