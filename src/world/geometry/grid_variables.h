// SPDX-License-Identifier: Apache-2.0
// Primitive variables of parametric surfaces (quadrics, meshes of patches) as patch polynomials.
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/geometry/patch_variables.h"

#include <functional>
#include <optional>
#include <span>

namespace candela {

/// Turns values of class vertex into polynomials; null: vertex is as varying, as on quadrics.
struct VertexBasis {
    int vertexCount = 0;
    std::function<PatchPolynomials(std::span<const float> values, int components)> convert;
};

class GridVariables {
public:
    /// Takes over the numeric variables; warns of and leaves out those with a wrong count. s and t
    /// are always there: by default Attributes::textureCoordinates over the mesh.
    GridVariables(const PrimitiveRecord &, const Attributes &, const PatchGrid &,
                  const VertexBasis *, DiagnosticSink &);

    std::span<const VariableInfo> infos() const { return variables_.infos(); }
    /// Surface::evaluateVariable at `count` mesh coordinates; answers begin at place `first`.
    void evaluate(int index, int first, int count, const float *meshU, const float *meshV,
                  float *const *value, float *const *valueDu, float *const *valueDv) const;
    bool hasNormals() const { return variables_.hasNormals(); }
    /// PatchVariables::overrideNormals at mesh coordinates.
    void overrideNormals(int count, const float *meshU, const float *meshV, Vec3Planes N,
                         Vec3Planes dNdu, Vec3Planes dNdv) const;

private:
    std::optional<PatchPolynomials> convert(const NumericVariable &, const VertexBasis *,
                                            const SourceLocation &, DiagnosticSink &) const;
    PatchPolynomials perSegment(const NumericVariable &) const;
    PatchPolynomials perMeshCorner(const NumericVariable &) const;
    PatchPolynomials perSegmentCorner(const NumericVariable &) const;
    PatchVariables::Locate locator(const float *meshU, const float *meshV) const;

    PatchGrid grid_;
    PatchVariables variables_;
};

} // namespace candela
