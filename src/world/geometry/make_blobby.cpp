// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/make_blobby.h"

#include "world/geometry/blob_mesh.h"
#include "world/geometry/polygon_surface.h"
#include "world/geometry/primitive_variables.h"

namespace candela {

namespace {

std::vector<float> flat(const std::vector<Vec3> &vectors) {
    std::vector<float> floats;
    floats.reserve(3 * vectors.size());
    for (Vec3 v : vectors)
        floats.insert(floats.end(), {v.x, v.y, v.z});
    return floats;
}

bool isPerBlob(const Parameter &variable) {
    return variable.declaration.storage != StorageClass::Constant &&
           variable.declaration.storage != StorageClass::Uniform &&
           variable.declaration.type != ValueType::String;
}

/// The values of blobs, blended at vertices as their fields are.
Parameter blended(const BlobField &field, const std::vector<Vec3> &positions, Parameter variable) {
    const auto leaves = std::size_t(field.leaves());
    const auto size = std::size_t(std::max(1, variable.declaration.components()));
    std::vector<float> shares(leaves), values;
    values.reserve(positions.size() * size);
    for (Vec3 position : positions) {
        field.sharesAt(position, shares);
        for (std::size_t c = 0; c < size; ++c) {
            float sum = 0;
            for (std::size_t leaf = 0; leaf < leaves; ++leaf)
                sum += shares[leaf] * variable.floats[leaf * size + c];
            values.push_back(sum);
        }
    }
    variable.floats = std::move(values);
    variable.declaration.storage = StorageClass::Vertex;
    return variable;
}

} // namespace

std::vector<std::shared_ptr<const Surface>>
makeBlobby(const BlobbyRecord &blobby, const PrimitiveRecord &record, DiagnosticSink &diagnostics) {
    const auto field = BlobField::make(blobby, record.where, diagnostics);
    if (!field)
        return {};
    BlobMesh mesh = meshOf(*field);
    const bool isCoarse = !field->blobs().empty() && mesh.cellsAcross < fewestCellsAcross;
    if (isCoarse)
        diagnostics.warning(record.where,
                            "blobs of this blobby are so much smaller or flatter than it is large, "
                            "or they and their codes are so many, that they come out coarse or not "
                            "at all; a blobby of their own helps");
    if (mesh.triangles.empty() && isCoarse)
        return {};
    if (mesh.triangles.empty()) {
        diagnostics.warning(record.where,
                            "the blobby has no surface: its field is the threshold nowhere");
        return {};
    }
    PolygonsRecord polygons;
    polygons.loopCounts.assign(mesh.triangles.size(), 1);
    polygons.vertexCounts.assign(mesh.triangles.size(), 3);
    for (const auto &triangle : mesh.triangles)
        polygons.vertices.insert(polygons.vertices.end(), triangle.begin(), triangle.end());
    PrimitiveRecord meshed;
    meshed.where = record.where;
    ParameterList &variables = meshed.variables;
    variables.where = record.where;
    variables.all.push_back(
        {"P", {StorageClass::Vertex, ValueType::Point, 1}, flat(mesh.positions), {}});
    variables.all.push_back(
        {"N", {StorageClass::Vertex, ValueType::Normal, 1}, flat(mesh.normals), {}});
    for (const Parameter &variable : record.variables.all) {
        if (variable.name == "P" || variable.name == "N")
            continue;
        if (isPerBlob(variable)) {
            variables.all.push_back(blended(*field, mesh.positions, variable));
        } else {
            variables.all.push_back(variable);
            variables.all.back().declaration.storage = StorageClass::Constant;
        }
    }
    meshed.shape = std::move(polygons);
    auto faces = triangulateFaces(std::get<PolygonsRecord>(meshed.shape), meshed, diagnostics);
    if (!faces)
        return {};
    return {std::make_shared<PolygonSurface>(std::move(*faces), meshed, diagnostics)};
}

} // namespace candela
