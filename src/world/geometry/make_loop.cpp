// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/make_loop.h"

#include "world/geometry/bezier_net.h"
#include "world/geometry/loop_refinement.h"
#include "world/geometry/make_subdivision.h"
#include "world/geometry/polygon_surface.h"
#include "world/geometry/subdivision_values.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candela {

namespace {

/// A mesh of triangles, and what they are of the one that was given.
struct TriangleMesh {
    SubdivisionRecord mesh;
    std::vector<int> faces;   ///< Of each triangle: its face.
    std::vector<int> corners; ///< Of each corner: its place in the given vertices.
    int cut = 0;              ///< Faces that were no triangles.
};

/// Faces of more corners become fans around their first one.
TriangleMesh triangleMesh(const SubdivisionRecord &given) {
    TriangleMesh result;
    SubdivisionRecord &mesh = result.mesh;
    mesh = given;
    mesh.vertexCounts.clear(), mesh.vertices.clear(), mesh.holes.clear();
    std::vector<bool> isHole(given.vertexCounts.size());
    for (int face : given.holes)
        isHole[std::size_t(face)] = true;
    int first = 0;
    for (int face = 0; face < int(given.vertexCounts.size()); ++face) {
        const int count = given.vertexCounts[std::size_t(face)];
        result.cut += count > 3;
        for (int k = 1; k + 1 < count; ++k) {
            if (isHole[std::size_t(face)])
                mesh.holes.push_back(int(mesh.vertexCounts.size()));
            mesh.vertexCounts.push_back(3);
            result.faces.push_back(face);
            for (int corner : {first, first + k, first + k + 1}) {
                result.corners.push_back(corner);
                mesh.vertices.push_back(given.vertices[std::size_t(corner)]);
            }
        }
        first += count;
    }
    return result;
}

/// What is drawn of the refined mesh, as polygons.
class LoopPolygons {
public:
    LoopPolygons(const TriangleMesh &base, const LoopRefinement &refinement,
                 const PrimitiveRecord &record)
        : base_(base), refinement_(refinement), record_(record) {
        meshed_.where = meshed_.variables.where = record.where;
        PolygonsRecord polygons;
        for (std::size_t k = 0; k < refinement.triangles().size(); ++k)
            if (!refinement.triangles()[k].isHole) {
                drawn_.push_back(k);
                const auto &vertices = refinement.triangles()[k].vertices;
                polygons.vertices.insert(polygons.vertices.end(), vertices.begin(), vertices.end());
            }
        polygons.loopCounts.assign(drawn_.size(), 1);
        polygons.vertexCounts.assign(drawn_.size(), 3);
        meshed_.shape = std::move(polygons);
    }

    bool isEmpty() const { return drawn_.empty(); }
    const PrimitiveRecord &meshed() const { return meshed_; }

    /// False if they are of no size to be computed with.
    bool addPositions(std::span<const float> positions) {
        std::vector<float> limit = refinement_.limit(positions, 3);
        Box3 box;
        for (std::size_t i = 0; i < limit.size(); i += 3)
            box.add(Vec3{limit[i], limit[i + 1], limit[i + 2]});
        add("P", {StorageClass::Vertex, ValueType::Point, 1}, std::move(limit));
        return hasUsableSize(box);
    }

    void addNormals(std::span<const float> positions) {
        // Of about the size of 1: products of small ways and of large ones are within range.
        float largest = 0;
        for (float x : positions)
            largest = std::max(largest, std::fabs(x));
        std::vector<float> scaled(positions.begin(), positions.end());
        for (float &x : scaled)
            x = std::ldexp(x, -std::ilogb(largest));
        std::vector<float> normals;
        const std::vector<Vec3> all = refinement_.normals(scaled);
        for (std::size_t k : drawn_)
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const Vec3 n = all[3 * k + corner];
                normals.insert(normals.end(), {n.x, n.y, n.z});
            }
        add("N", {StorageClass::FaceVarying, ValueType::Normal, 1}, std::move(normals));
    }

    /// Of whatever class; with a warning if its count is wrong.
    void add(const NumericVariable &variable, DiagnosticSink &diagnostics) {
        const SubdivisionRecord &mesh = base_.mesh;
        const auto has = [&](std::size_t expected) {
            if (variable.count() != int(expected))
                reportWrongCount(variable, long(expected), record_.where, diagnostics);
            return variable.count() == int(expected);
        };
        const std::size_t vertices = std::size_t(pointCount());
        switch (variable.declaration.storage) {
        case StorageClass::Constant:
            if (has(1))
                add(variable, StorageClass::Constant, variable.values);
            break;
        case StorageClass::Uniform:
            if (has(givenFaces()))
                addPerFace(variable);
            break;
        case StorageClass::Varying:
            if (has(vertices))
                addPerCorner(variable, [&](std::size_t corner) { return mesh.vertices[corner]; });
            break;
        case StorageClass::Vertex:
            if (has(vertices))
                add(variable, StorageClass::Vertex,
                    refinement_.limit(variable.values, variable.components));
            break;
        case StorageClass::FaceVarying:
        case StorageClass::FaceVertex:
            if (has(givenCorners()))
                addOfCorners(variable);
            break;
        }
    }

    /// Texture coordinates where none are given: (s,t) at the first three corners of a square.
    void addTextureCoordinates(const std::array<float, 8> &square) {
        std::vector<float> values;
        for (std::size_t k : drawn_)
            for (const LoopRefinement::Place &place : refinement_.triangles()[k].places)
                for (std::size_t axis : {0u, 1u})
                    values.push_back(square[axis] + place[0] * (square[2 + axis] - square[axis]) +
                                     place[1] * (square[4 + axis] - square[axis]));
        add("st", {StorageClass::FaceVarying, ValueType::Float, 2}, std::move(values));
    }

private:
    std::size_t pointCount() const { return record_.variables.find("P")->floats.size() / 3; }
    std::size_t givenFaces() const {
        return std::get<SubdivisionRecord>(record_.shape).vertexCounts.size();
    }
    std::size_t givenCorners() const {
        return std::get<SubdivisionRecord>(record_.shape).vertices.size();
    }

    void add(const std::string &name, const Declaration &declaration, std::vector<float> floats) {
        meshed_.variables.all.push_back({name, declaration, std::move(floats), {}});
    }
    void add(const NumericVariable &variable, StorageClass storage, std::vector<float> floats) {
        Declaration declaration = variable.declaration;
        declaration.storage = storage;
        add(variable.name, declaration, std::move(floats));
    }

    void addPerFace(const NumericVariable &variable) {
        std::vector<float> values;
        for (std::size_t k : drawn_) {
            const int triangle = refinement_.triangles()[k].face;
            const auto value =
                variable.values.begin() + base_.faces[std::size_t(triangle)] * variable.components;
            values.insert(values.end(), value, value + variable.components);
        }
        add(variable, StorageClass::Uniform, std::move(values));
    }

    /// Linear on each triangle of the mesh, whose corners have their values at `placeOf` each.
    template <class PlaceOf> void addPerCorner(const NumericVariable &variable, PlaceOf placeOf) {
        const auto n = std::size_t(variable.components);
        std::vector<float> values;
        for (std::size_t k : drawn_) {
            const LoopRefinement::Triangle &triangle = refinement_.triangles()[k];
            const auto value = [&](int corner, std::size_t c) {
                const auto at = std::size_t(placeOf(std::size_t(3 * triangle.face + corner)));
                return variable.values[at * n + c];
            };
            for (const LoopRefinement::Place &place : triangle.places)
                for (std::size_t c = 0; c < n; ++c)
                    values.push_back(value(0, c) + place[0] * (value(1, c) - value(0, c)) +
                                     place[1] * (value(2, c) - value(0, c)));
        }
        add(variable, StorageClass::FaceVarying, std::move(values));
    }

    /// Smooth within the regions over which they are continuous, if that is asked for.
    void addOfCorners(const NumericVariable &variable) {
        const SubdivisionRecord &mesh = base_.mesh;
        const auto ownCorner = [&](std::size_t corner) { return base_.corners[corner]; };
        if (variable.declaration.storage == StorageClass::FaceVarying &&
            mesh.faceVaryingBoundary == 0)
            return addPerCorner(variable, ownCorner);
        NumericVariable ofTriangles = variable;
        ofTriangles.values.clear();
        for (int corner : base_.corners) {
            const auto value = variable.values.begin() + corner * variable.components;
            ofTriangles.values.insert(ofTriangles.values.end(), value, value + variable.components);
        }
        const ValueMesh smooth = valueMesh(ofTriangles, mesh);
        std::string why;
        const auto own =
            LoopRefinement::of(smooth.mesh, smooth.vertices, LoopRefinement::levelsFor(mesh), why);
        if (!own)
            return addPerCorner(variable, ownCorner);
        const std::vector<float> limit = own->limit(smooth.values, variable.components);
        std::vector<float> values;
        for (std::size_t k : drawn_)
            for (int vertex : own->triangles()[k].vertices) {
                const auto value = limit.begin() + vertex * variable.components;
                values.insert(values.end(), value, value + variable.components);
            }
        add(variable, StorageClass::FaceVarying, std::move(values));
    }

    const TriangleMesh &base_;
    const LoopRefinement &refinement_;
    const PrimitiveRecord &record_;
    PrimitiveRecord meshed_;
    std::vector<std::size_t> drawn_; ///< Of the refined triangles.
};

} // namespace

SurfaceList makeLoop(const SubdivisionRecord &given, const PrimitiveRecord &record,
                     const Attributes &attributes, DiagnosticSink &diagnostics) {
    const TriangleMesh base = triangleMesh(given);
    if (base.cut > 0)
        diagnostics.warning(record.where,
                            std::to_string(base.cut) +
                                " faces of the subdivision mesh have more than three corners: the "
                                "scheme \"loop\" is for triangles, and they are cut into some");
    const std::vector<float> &positions = record.variables.find("P")->floats;
    std::string why;
    const auto refinement = LoopRefinement::of(base.mesh, int(positions.size() / 3),
                                               LoopRefinement::levelsFor(base.mesh), why);
    if (!refinement) {
        diagnostics.error(record.where, "the subdivision mesh " + why + "; it is dropped");
        return {};
    }
    reportStrayCreases(refinement->strayCreases(), record.where, diagnostics);
    LoopPolygons polygons(base, *refinement, record);
    if (polygons.isEmpty()) {
        reportNothingDrawn(record.where, diagnostics);
        return {};
    }
    if (!polygons.addPositions(positions)) {
        diagnostics.error(record.where, "the subdivision mesh is too large or too small to be "
                                        "computed with; it is dropped");
        return {};
    }
    bool hasNormals = false, hasTextureCoordinates = false;
    for (const NumericVariable &variable : numericVariables(record, diagnostics)) {
        hasNormals |= variable.name == "N" || variable.name == "Np";
        hasTextureCoordinates |= variable.name == "s" || variable.name == "t";
        polygons.add(variable, diagnostics);
    }
    if (!hasNormals)
        polygons.addNormals(positions);
    if (!hasTextureCoordinates)
        polygons.addTextureCoordinates(attributes.textureCoordinates);
    // Far away, small triangles may be none to floats; they are nobody's fault.
    DiagnosticList unheard;
    auto mesh = triangulateFaces(std::get<PolygonsRecord>(polygons.meshed().shape),
                                 polygons.meshed(), unheard);
    if (!mesh) {
        diagnostics.error(record.where, "the subdivision mesh has no area; it is dropped");
        return {};
    }
    return {std::make_shared<PolygonSurface>(std::move(*mesh), polygons.meshed(), diagnostics)};
}

} // namespace candela
