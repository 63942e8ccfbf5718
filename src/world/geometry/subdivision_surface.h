// SPDX-License-Identifier: Apache-2.0
// Subdivision meshes (RI 3.2, 5.3): their limit surfaces.
#pragma once

#include "world/geometry/subdivision_dicing.h"
#include "world/geometry/subdivision_variables.h"

namespace candela {

/// A query's piece is a face of four vertices, or a corner of another face; (u,v) are RI's, from 0
/// to 1 over it. Faces that are holes, and those at a boundary that is not interpolated, are none.
class SubdivisionSurface final : public Surface {
public:
    SubdivisionSurface(SubdivisionShape, PatchPositions, std::span<const PatchBounds> leaves,
                       SubdivisionVariables);

    /// False if every normal vanishes.
    bool hasArea() const;

    SurfaceDomain domain() const override { return {std::uint32_t(shape_.pieces.size()), false}; }
    Box3 bound() const override { return bound_; }
    DicedMesh dice(const DiceRate &) const override;
    double triangleCount(const DiceRate &) const override;
    float area() const override;
    void evaluate(const SurfaceQuery &, const SurfaceAnswer &) const override;
    bool hasOwnNormals() const override { return variables_.hasNormals(); }
    std::span<const VariableInfo> variables() const override { return variables_.infos(); }
    void evaluateVariable(int index, const SurfaceQuery &, float *const *value,
                          float *const *valueDu, float *const *valueDv) const override;

private:
    SubdivisionShape shape_;
    PatchPositions positions_;
    SubdivisionVariables variables_;
    Box3 bound_;
    double roundingError_ = 0; ///< Of evaluate(), in object units.
};

} // namespace candela
