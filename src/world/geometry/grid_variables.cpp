// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/grid_variables.h"

#include <algorithm>

namespace candela {

GridVariables::GridVariables(const PrimitiveRecord &record, const Attributes &attributes,
                             const PatchGrid &grid, const VertexBasis *basis,
                             DiagnosticSink &diagnostics)
    : grid_(grid) {
    for (const NumericVariable &variable : numericVariables(record, diagnostics)) {
        auto polynomials = convert(variable, basis, record.where, diagnostics);
        if (!polynomials)
            continue;
        if (variable.name == "N" || (variable.name == "Np" && !normal_)) {
            normal_ = std::move(polynomials);
        } else if (variable.name != "Np") {
            infos_.push_back({variable.name, variable.declaration});
            polynomials_.push_back(std::move(*polynomials));
        }
    }
    addDefault("s", attributes.textureCoordinates, 0);
    addDefault("t", attributes.textureCoordinates, 1);
}

void GridVariables::addDefault(const char *name, const std::array<float, 8> &coordinates,
                               int offset) {
    if (std::ranges::find(infos_, name, &VariableInfo::name) != infos_.end())
        return;
    PatchPolynomials polynomials{1, 1, true};
    appendBilinear(polynomials.coefficients, coordinates[offset], coordinates[2 + offset],
                   coordinates[4 + offset], coordinates[6 + offset]);
    infos_.push_back({name, {StorageClass::Varying, ValueType::Float, 1}});
    polynomials_.push_back(std::move(polynomials));
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

void GridVariables::evaluate(int index, int first, int count, const float *meshU,
                             const float *meshV, float *const *value, float *const *valueDu,
                             float *const *valueDv) const {
    const PatchPolynomials &polynomials = polynomials_[index];
    PatchPoints points;
    for (int start = 0; start < count; start += PatchPoints::capacity) {
        locate(grid_, meshU + start, meshV + start, std::min(count - start, points.capacity),
               points);
        for (int c = 0; c < polynomials.components; ++c)
            polynomials.evaluate(points, c, value ? value[c] + first + start : nullptr,
                                 valueDu ? valueDu[c] + first + start : nullptr,
                                 valueDv ? valueDv[c] + first + start : nullptr);
    }
}

void GridVariables::overrideNormals(int count, const float *meshU, const float *meshV, Vec3Planes N,
                                    Vec3Planes dNdu, Vec3Planes dNdv) const {
    if (!normal_)
        return;
    PatchPoints points;
    std::array<float, PatchPoints::capacity> value[3], du[3], dv[3];
    for (int start = 0; start < count; start += PatchPoints::capacity) {
        locate(grid_, meshU + start, meshV + start, std::min(count - start, points.capacity),
               points);
        for (int c = 0; c < 3; ++c)
            normal_->evaluate(points, c, value[c].data(), du[c].data(), dv[c].data());
        for (int k = 0; k < points.count; ++k) {
            Vec3 n{value[0][k], value[1][k], value[2][k]};
            if (!(dot(n, n) > 0))
                continue;
            if (N.x)
                N.set(start + k, n);
            if (dNdu.x)
                dNdu.set(start + k, unitDerivative(n, {du[0][k], du[1][k], du[2][k]}));
            if (dNdv.x)
                dNdv.set(start + k, unitDerivative(n, {dv[0][k], dv[1][k], dv[2][k]}));
        }
    }
}

} // namespace candela
