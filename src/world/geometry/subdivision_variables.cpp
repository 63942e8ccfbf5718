// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/subdivision_variables.h"

#include "world/geometry/subdivision_values.h"

#include <algorithm>
#include <numeric>

namespace candela {

namespace {

/// Where the vertices of each face begin.
std::vector<std::size_t> firstVertices(const SubdivisionRecord &mesh) {
    std::vector<std::size_t> first(mesh.vertexCounts.size());
    std::exclusive_scan(mesh.vertexCounts.begin(), mesh.vertexCounts.end(), first.begin(),
                        std::size_t(0));
    return first;
}

/// Bilinear on each piece, from the values at the corners of faces, which stand at `placeOf` each.
template <class PlaceOf>
PatchPolynomials perCorner(const NumericVariable &variable, const SubdivisionRecord &mesh,
                           std::span<const SubdivisionPiece> pieces, PlaceOf placeOf) {
    const int n = variable.components;
    const std::vector<std::size_t> first = firstVertices(mesh);
    PatchPolynomials result{1, n};
    for (const SubdivisionPiece &piece : pieces) {
        const int count = mesh.vertexCounts[piece.face];
        for (int c = 0; c < n; ++c) {
            const auto at = [&](int k) {
                const std::size_t corner = first[piece.face] + std::size_t(k % count);
                return variable
                    .values[std::size_t(placeOf(corner)) * std::size_t(n) + std::size_t(c)];
            };
            const int k = piece.corner;
            if (k < 0) {
                appendBilinear(result.coefficients, at(0), at(1), at(3), at(2));
                continue;
            }
            float sum = 0;
            for (int i = 0; i < count; ++i)
                sum += at(i);
            appendBilinear(result.coefficients, at(k), (at(k) + at(k + 1)) / 2,
                           (at(k) + at(k + count - 1)) / 2, sum / float(count));
        }
    }
    return result;
}

PatchPolynomials perFace(const NumericVariable &variable,
                         std::span<const SubdivisionPiece> pieces) {
    PatchPolynomials result{0, variable.components};
    for (const SubdivisionPiece &piece : pieces) {
        const auto value = variable.values.begin() + std::ptrdiff_t(piece.face) * result.components;
        result.coefficients.insert(result.coefficients.end(), value, value + result.components);
    }
    return result;
}

} // namespace

SubdivisionVariables::SubdivisionVariables(
    const SubdivisionRecord &mesh, const PrimitiveRecord &record, const Attributes &attributes,
    const SubdivisionRefinement &refinement, std::span<const std::uint32_t> numbers,
    std::shared_ptr<const SubdivisionTree> tree, DiagnosticSink &diagnostics)
    : numbers_(numbers.begin(), numbers.end()), trees_{std::move(tree)} {
    std::vector<SubdivisionPiece> pieces;
    for (std::uint32_t number : numbers_)
        pieces.push_back(refinement.pieces()[number]);
    const int vertices = int(refinement.edges().vertices), corners = int(mesh.vertices.size());
    const auto ownVertex = [&](std::size_t corner) { return mesh.vertices[corner]; };
    const auto itself = [](std::size_t corner) { return corner; };
    for (const NumericVariable &variable : numericVariables(record, diagnostics)) {
        const auto has = [&](int expected) {
            if (variable.count() != expected)
                reportWrongCount(variable, expected, record.where, diagnostics);
            return variable.count() == expected;
        };
        StorageClass storage = variable.declaration.storage;
        if (storage == StorageClass::FaceVarying && mesh.faceVaryingBoundary != 0)
            storage = StorageClass::FaceVertex;
        switch (storage) {
        case StorageClass::Constant:
            if (has(1))
                variables_.add(variable, {0, variable.components, true, variable.values});
            break;
        case StorageClass::Uniform:
            if (has(int(mesh.vertexCounts.size())))
                variables_.add(variable, perFace(variable, pieces));
            break;
        case StorageClass::Varying:
            if (has(vertices))
                variables_.add(variable, perCorner(variable, mesh, pieces, ownVertex));
            break;
        case StorageClass::FaceVarying:
            if (has(corners))
                variables_.add(variable, perCorner(variable, mesh, pieces, itself));
            break;
        case StorageClass::Vertex:
            if (has(vertices))
                variables_.add(variable, refinement.convert(variable.values, variable.components),
                               1);
            break;
        case StorageClass::FaceVertex:
            if (has(corners)) {
                const ValueMesh smooth = valueMesh(variable, mesh);
                std::string why;
                if (const auto own = SubdivisionRefinement::of(smooth.mesh, smooth.vertices, why)) {
                    trees_.push_back(std::make_shared<SubdivisionTree>(own->tree()));
                    variables_.add(variable, own->convert(smooth.values, variable.components),
                                   int(trees_.size()));
                } else {
                    variables_.add(variable, perCorner(variable, mesh, pieces, itself));
                }
            }
            break;
        }
    }
    variables_.addTextureCoordinates(attributes.textureCoordinates);
}

PatchVariables::Locate SubdivisionVariables::locator(const SurfaceQuery &query) const {
    return [&query, this](int space, int start, int count, PatchPoints &points) {
        std::array<std::uint32_t, PatchPoints::capacity> piece{};
        for (int k = 0; k < count; ++k)
            piece[k] = numbers_[query.piece[start + k]];
        const SubdivisionTree &tree = *trees_[std::max(space - 1, 0)];
        tree.locate(count, piece.data(), query.u + start, query.v + start, points);
        if (space > 0)
            return;
        for (int k = 0; k < count; ++k)
            points.patch[k] = int(query.piece[start + k]);
        points.u = points.meshU, points.v = points.meshV;
        points.speedU.fill(1), points.speedV.fill(1);
    };
}

void SubdivisionVariables::evaluate(int index, const SurfaceQuery &query, float *const *value,
                                    float *const *valueDu, float *const *valueDv) const {
    variables_.evaluate(index, 0, query.count, locator(query), value, valueDu, valueDv);
}

void SubdivisionVariables::overrideNormals(const SurfaceQuery &query,
                                           const SurfaceAnswer &answer) const {
    if (hasNormals())
        variables_.overrideNormals(query.count, locator(query), answer.N, answer.dNdu, answer.dNdv);
}

} // namespace candela
