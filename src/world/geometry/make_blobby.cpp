// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/make_blobby.h"

#include "world/geometry/blob_motion.h"
#include "world/geometry/moving_surface.h"
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

struct MeshedBlobby {
    BlobField field;
    BlobMesh mesh;
};

/// Nothing, with a report, if there is no surface.
std::optional<MeshedBlobby> meshed(const PrimitiveRecord &record, DiagnosticSink &diagnostics) {
    auto field = BlobField::make(std::get<BlobbyRecord>(record.shape), record.where, diagnostics);
    if (!field)
        return std::nullopt;
    BlobMesh mesh = meshOf(*field);
    const bool isCoarse = !field->blobs().empty() && mesh.cellsAcross < fewestCellsAcross;
    if (isCoarse)
        diagnostics.warning(record.where,
                            "blobs of this blobby are so much smaller or flatter than it is large, "
                            "or they and their codes are so many, that they come out coarse or not "
                            "at all; a blobby of their own helps");
    else if (mesh.triangles.empty())
        diagnostics.warning(record.where,
                            "the blobby has no surface: its field is the threshold nowhere");
    if (mesh.triangles.empty())
        return std::nullopt;
    return MeshedBlobby{std::move(*field), std::move(mesh)};
}

/// The mesh with the variables of the blobby that it is of.
PrimitiveRecord polygonsOf(const MeshedBlobby &blobby, const PrimitiveRecord &record) {
    const BlobMesh &mesh = blobby.mesh;
    PolygonsRecord polygons;
    polygons.loopCounts.assign(mesh.triangles.size(), 1);
    polygons.vertexCounts.assign(mesh.triangles.size(), 3);
    for (const auto &triangle : mesh.triangles)
        polygons.vertices.insert(polygons.vertices.end(), triangle.begin(), triangle.end());
    PrimitiveRecord result;
    result.shape = std::move(polygons);
    result.where = record.where;
    ParameterList &variables = result.variables;
    variables.where = record.where;
    variables.all.push_back(
        {"P", {StorageClass::Vertex, ValueType::Point, 1}, flat(mesh.positions), {}});
    variables.all.push_back(
        {"N", {StorageClass::Vertex, ValueType::Normal, 1}, flat(mesh.normals), {}});
    for (const Parameter &variable : record.variables.all) {
        if (variable.name == "P" || variable.name == "N")
            continue;
        if (isPerBlob(variable)) {
            variables.all.push_back(blended(blobby.field, mesh.positions, variable));
        } else {
            variables.all.push_back(variable);
            variables.all.back().declaration.storage = StorageClass::Constant;
        }
    }
    return result;
}

/// Null if there are no faces.
std::shared_ptr<const PolygonSurface>
surfaceOf(const MeshedBlobby &blobby, const PrimitiveRecord &record, DiagnosticSink &diagnostics) {
    const PrimitiveRecord polygons = polygonsOf(blobby, record);
    auto faces = triangulateFaces(std::get<PolygonsRecord>(polygons.shape), polygons, diagnostics);
    if (!faces)
        return nullptr;
    return std::make_shared<PolygonSurface>(std::move(*faces), polygons, diagnostics);
}

/// What the surface of the blobby is when that has become this; null if it has come apart.
std::shared_ptr<const Surface> laterSurface(const PolygonSurface &surface,
                                            const MeshedBlobby &blobby,
                                            const PrimitiveRecord &later,
                                            DiagnosticSink &diagnostics) {
    auto field = BlobField::make(std::get<BlobbyRecord>(later.shape), later.where, diagnostics);
    auto mesh = field ? carriedTo(*field, blobby.field, blobby.mesh) : std::nullopt;
    if (!mesh)
        return nullptr;
    auto moved =
        surface.movedTo(polygonsOf({std::move(*field), std::move(*mesh)}, later), diagnostics);
    return moved && haveSameNames(surface, *moved) ? moved : nullptr;
}

} // namespace

SurfaceList makeBlobby(const PrimitiveRecord &record, DiagnosticSink &diagnostics) {
    const auto blobby = meshed(record, diagnostics);
    auto surface = blobby ? surfaceOf(*blobby, record, diagnostics) : nullptr;
    return surface ? SurfaceList{std::move(surface)} : SurfaceList{};
}

SurfaceList makeMovingBlobby(const std::vector<std::shared_ptr<const PrimitiveRecord>> &inTime,
                             DiagnosticSink &diagnostics) {
    const PrimitiveRecord &record = *inTime.front();
    const auto blobby = meshed(record, diagnostics);
    const auto surface = blobby ? surfaceOf(*blobby, record, diagnostics) : nullptr;
    if (!surface)
        return {};
    SurfaceList steps{surface};
    DiagnosticList heard; // It has been said of the first.
    for (std::size_t k = 1; k < inTime.size(); ++k) {
        steps.push_back(laterSurface(*surface, *blobby, *inTime[k], heard));
        if (!steps.back()) {
            diagnostics.warning(record.where,
                                "blobs part, vanish or lose variables while the shutter is open: "
                                "the blobby keeps its shape");
            return {surface};
        }
    }
    return {std::make_shared<MovingSurface>(std::move(steps))};
}

} // namespace candela
