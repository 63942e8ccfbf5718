// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/grid_variables.h"

#include <algorithm>

namespace candela {

GridVariables::GridVariables(const PrimitiveRecord &record, const Attributes &attributes,
                             const PatchGrid &grid, const VertexBasis *basis,
                             DiagnosticSink &diagnostics)
    : grid_(grid) {
    for (const NumericVariable &variable : numericVariables(record, diagnostics))
        if (auto polynomials = convert(variable, basis, record.where, diagnostics))
            variables_.add(variable, std::move(*polynomials));
    variables_.addTextureCoordinates(attributes.textureCoordinates);
}

/// The segment that a patch is; see PatchAxis.
static std::size_t segmentOf(const PatchGrid &grid, int patch) {
    const int column = patch % grid.u.patches, row = patch / grid.u.patches;
    return std::size_t(grid.v.segment(row)) * grid.u.segments() + grid.u.segment(column);
}

PatchPolynomials GridVariables::perSegment(const NumericVariable &variable) const {
    const int n = variable.components;
    PatchPolynomials result{0, n, variable.count() == 1};
    for (int patch = 0; patch < (result.wholeMesh ? 1 : grid_.patches()); ++patch) {
        const auto value = variable.values.begin() + segmentOf(grid_, patch) * n;
        result.coefficients.insert(result.coefficients.end(), value, value + n);
    }
    return result;
}

PatchPolynomials GridVariables::perMeshCorner(const NumericVariable &variable) const {
    PatchPolynomials result{1, variable.components};
    result.coefficients.reserve(std::size_t(grid_.patches()) * variable.components * 4);
    auto at = [&](int column, int row, int component) {
        int corner = row % grid_.v.corners() * grid_.u.corners() + column % grid_.u.corners();
        return variable.values[std::size_t(corner) * variable.components + component];
    };
    for (int patch = 0; patch < grid_.patches(); ++patch) {
        const int column = grid_.u.segment(patch % grid_.u.patches);
        const int row = grid_.v.segment(patch / grid_.u.patches);
        for (int c = 0; c < variable.components; ++c)
            appendBilinear(result.coefficients, at(column, row, c), at(column + 1, row, c),
                           at(column, row + 1, c), at(column + 1, row + 1, c));
    }
    return result;
}

/// Bilinear over the whole mesh, from its corners.
static PatchPolynomials overAll(const NumericVariable &variable) {
    const int n = variable.components;
    PatchPolynomials result{1, n, true};
    for (int c = 0; c < n; ++c)
        appendBilinear(result.coefficients, variable.values[c], variable.values[n + c],
                       variable.values[2 * n + c], variable.values[3 * n + c]);
    return result;
}

PatchPolynomials GridVariables::perSegmentCorner(const NumericVariable &variable) const {
    int n = variable.components;
    PatchPolynomials result{1, n};
    for (int patch = 0; patch < grid_.patches(); ++patch) {
        const float *corner = &variable.values[segmentOf(grid_, patch) * 4 * n];
        for (int c = 0; c < n; ++c)
            appendBilinear(result.coefficients, corner[c], corner[n + c], corner[2 * n + c],
                           corner[3 * n + c]);
    }
    return result;
}

std::optional<PatchPolynomials> GridVariables::convert(const NumericVariable &variable,
                                                       const VertexBasis *basis,
                                                       const SourceLocation &where,
                                                       DiagnosticSink &diagnostics) const {
    int count = variable.count();
    auto expect = [&](int expected) {
        if (count != expected)
            reportWrongCount(variable, expected, where, diagnostics);
        return count == expected;
    };
    switch (variable.declaration.storage) {
    case StorageClass::Constant:
        if (expect(1))
            return perSegment(variable);
        break;
    case StorageClass::Uniform:
        if (expect(grid_.segments()))
            return perSegment(variable);
        break;
    case StorageClass::FaceVarying:
    case StorageClass::FaceVertex:
        if (count == 4 * grid_.segments())
            return perSegmentCorner(variable);
        [[fallthrough]];
    case StorageClass::Varying:
        if (count == 4 && !grid_.u.segmentOf.empty() && grid_.corners() != 4)
            return overAll(variable);
        if (expect(grid_.corners()))
            return perMeshCorner(variable);
        break;
    case StorageClass::Vertex:
        if (!basis && expect(grid_.corners()))
            return perMeshCorner(variable);
        if (basis && expect(basis->vertexCount))
            return basis->convert(variable.values, variable.components);
        break;
    }
    return std::nullopt;
}

PatchVariables::Locate GridVariables::locator(const float *meshU, const float *meshV) const {
    return [=, this](int, int start, int count, PatchPoints &points) {
        locate(grid_, meshU + start, meshV + start, count, points);
    };
}

void GridVariables::evaluate(int index, int first, int count, const float *meshU,
                             const float *meshV, float *const *value, float *const *valueDu,
                             float *const *valueDv) const {
    variables_.evaluate(index, first, count, locator(meshU, meshV), value, valueDu, valueDv);
}

void GridVariables::overrideNormals(int count, const float *meshU, const float *meshV, Vec3Planes N,
                                    Vec3Planes dNdu, Vec3Planes dNdv) const {
    if (hasNormals())
        variables_.overrideNormals(count, locator(meshU, meshV), N, dNdu, dNdv);
}

} // namespace candela
