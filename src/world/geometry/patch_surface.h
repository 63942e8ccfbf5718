// SPDX-License-Identifier: Apache-2.0
// Patches and patch meshes (RI 3.2, 5.2), bilinear and bicubic, polynomial and rational.
#pragma once

#include "world/geometry/grid_variables.h"
#include "world/geometry/patch_basis.h"

namespace candela {

/// A query's piece is 0 and its (u,v) are RI's, from 0 to 1 over the whole mesh. Where an edge has
/// collapsed to a point, dPdu, dPdv and Ng are those of a place just beside it.
class PatchSurface final : public Surface {
public:
    /// `positions` have 3 components, or 4 homogeneous ones; `bounds` are those of each patch.
    PatchSurface(const PatchTopology &, PatchPolynomials positions, std::vector<PatchBounds> bounds,
                 GridVariables);

    /// False if every normal vanishes.
    bool hasArea() const;

    Box3 bound() const override { return bound_; }
    DicedMesh dice(const DiceRate &) const override;
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
    template <int degree, bool rational> Vec3 beside(int patch, float u, float v, Local &) const;
    Vec3 normalAt(int patch, float u, float v) const;

    PatchTopology topology_;
    PatchPolynomials positions_;
    std::vector<PatchBounds> patchBounds_;
    std::vector<float> leastNormal_; ///< Of each patch: |dPdu x dPdv| below this is degenerate.
    GridVariables variables_;
    Box3 bound_;
    bool patchesMeet_ = true;
    double roundingError_ = 0; ///< Of evaluate(), in object units.
};

} // namespace candela
