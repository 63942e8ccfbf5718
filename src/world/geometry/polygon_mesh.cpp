// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/polygon_mesh.h"

#include "world/geometry/triangulate.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace candela {

/// Sum of counts, or -1 if one is negative.
static long total(const std::vector<int> &counts) {
    if (std::ranges::any_of(counts, [](int n) { return n < 0; }))
        return -1;
    return std::accumulate(counts.begin(), counts.end(), 0L);
}

static bool consistent(const PolygonsRecord &record, std::size_t pointCount) {
    return total(record.loopCounts) == long(record.vertexCounts.size()) &&
           total(record.vertexCounts) == long(record.vertices.size()) &&
           std::ranges::all_of(record.vertices, [&](int index) {
               return index >= 0 && std::size_t(index) < pointCount;
           });
}

std::vector<Vec3> pointsOf(const PrimitiveRecord &record, DiagnosticSink &diagnostics) {
    std::vector<float> homogeneous = homogeneousPoints(record, diagnostics);
    std::vector<Vec3> points;
    points.reserve(homogeneous.size() / 4);
    for (std::size_t i = 0; i < homogeneous.size(); i += 4)
        points.push_back(Vec3{homogeneous[i], homogeneous[i + 1], homogeneous[i + 2]} /
                         homogeneous[i + 3]);
    return points;
}

void addMadePoints(PolygonMesh &mesh) {
    for (const PolygonMesh::MadePoint &made : mesh.made) {
        const Vec3 a = mesh.points[made.points[0]], b = mesh.points[made.points[1]];
        mesh.points.push_back(a + (b - a) * made.share);
    }
}

namespace {

/// Values of the corners that are made, behind the given ones.
void addMadeValues(const PolygonMesh &mesh, PolygonVariable &variable) {
    const auto n = std::size_t(variable.components);
    for (const PolygonMesh::MadePoint &made : mesh.made) {
        const auto &[a, b] =
            variable.rate == PolygonVariable::Rate::Point ? made.points : made.places;
        for (std::size_t c = 0; c < n; ++c) {
            const float from = variable.values[a * n + c], to = variable.values[b * n + c];
            variable.values.push_back(from + (to - from) * made.share);
        }
    }
}

class FaceTriangulator {
public:
    FaceTriangulator(const PolygonsRecord &record, PolygonMesh &mesh)
        : record_(record), mesh_(mesh) {
        // Triangulation runs on places in record.vertices, so that facevarying values need no
        // search for their corner.
        corners_.reserve(record.vertices.size());
        for (int index : record.vertices)
            corners_.push_back(mesh.points[std::size_t(index)]);
        places_.resize(record.vertices.size());
        std::iota(places_.begin(), places_.end(), 0);
    }

    void run() {
        for (std::size_t face = 0; face < record_.loopCounts.size(); ++face)
            addFace(face);
    }

    void report(const SourceLocation &where, DiagnosticSink &diagnostics) const {
        auto tell = [&](const char *what, int count, std::size_t first) {
            diagnostics.warning(where, std::to_string(count) + " of " +
                                           std::to_string(record_.loopCounts.size()) + what +
                                           std::to_string(first));
        };
        if (degenerate_ > 0)
            tell(" polygons have no area and are left out; the first is number ", degenerate_,
                 firstDegenerate_);
        if (approximated_ > 0)
            tell(" polygons have a hole outside them or sides that cross too often, and are "
                 "approximated; the first is number ",
                 approximated_, firstApproximated_);
    }

private:
    void addFace(std::size_t face) {
        loops_.clear();
        for (int loop = 0; loop < record_.loopCounts[face]; ++loop) {
            auto count = std::size_t(record_.vertexCounts[nextLoop_++]);
            loops_.push_back(std::span<const int>(places_).subspan(nextVertex_, count));
            nextVertex_ += count;
        }
        auto result = triangulate(corners_, loops_, mesh_.faceVertices, made_);
        if (result == TriangulationResult::Degenerate && degenerate_++ == 0)
            firstDegenerate_ = face;
        if (result == TriangulationResult::Approximated && approximated_++ == 0)
            firstApproximated_ = face;
        takeMade();
        for (std::size_t i = mesh_.triangles.size(); i < mesh_.faceVertices.size(); ++i) {
            const auto &places = mesh_.faceVertices[i];
            const auto point = [&](int k) { return pointAt(places[k]); };
            mesh_.triangles.push_back({point(0), point(1), point(2)});
            mesh_.face.push_back(std::uint32_t(face));
        }
    }

    std::uint32_t pointAt(std::uint32_t place) const {
        const std::size_t given = record_.vertices.size();
        return place < given ? std::uint32_t(record_.vertices[place])
                             : std::uint32_t(mesh_.points.size() + (place - given));
    }

    void takeMade() {
        for (std::size_t k = mesh_.made.size(); k < made_.size(); ++k) {
            const auto [a, b] = made_[k].between;
            mesh_.made.push_back({{std::uint32_t(a), std::uint32_t(b)},
                                  {pointAt(std::uint32_t(a)), pointAt(std::uint32_t(b))},
                                  float(made_[k].share)});
        }
    }

    const PolygonsRecord &record_;
    PolygonMesh &mesh_;
    std::vector<MadeCorner> made_;
    std::vector<Vec3> corners_;
    std::vector<int> places_;
    std::vector<std::span<const int>> loops_;
    std::size_t nextLoop_ = 0, nextVertex_ = 0;
    int degenerate_ = 0, approximated_ = 0;
    std::size_t firstDegenerate_ = 0, firstApproximated_ = 0;
};

} // namespace

std::optional<PolygonMesh> triangulateFaces(const PolygonsRecord &polygons,
                                            const PrimitiveRecord &record,
                                            DiagnosticSink &diagnostics) {
    PolygonMesh mesh;
    mesh.points = pointsOf(record, diagnostics);
    if (mesh.points.empty())
        return std::nullopt;
    if (!consistent(polygons, mesh.points.size())) {
        diagnostics.error(record.where,
                          "the polygons' counts of loops and vertices do not add up "
                          "or name points that \"P\" does not hold; they are dropped");
        return std::nullopt;
    }
    mesh.faceCount = int(polygons.loopCounts.size());
    mesh.vertexCount = polygons.vertices.size();
    FaceTriangulator triangulator(polygons, mesh);
    triangulator.run();
    addMadePoints(mesh);
    if (mesh.triangles.empty()) {
        diagnostics.warning(record.where,
                            "no polygon of the primitive has an area; it is left out");
        return std::nullopt;
    }
    triangulator.report(record.where, diagnostics);
    return mesh;
}

std::optional<PolygonVariable> onPolygons(const NumericVariable &variable, const PolygonMesh &mesh,
                                          const SourceLocation &where,
                                          DiagnosticSink &diagnostics) {
    PolygonVariable result{PolygonVariable::Rate::Mesh, variable.components, variable.values};
    long expected = 1;
    switch (variable.declaration.storage) {
    case StorageClass::Constant: break;
    case StorageClass::Uniform:
        result.rate = PolygonVariable::Rate::Face;
        expected = mesh.faceCount;
        break;
    case StorageClass::Varying:
    case StorageClass::Vertex:
        result.rate = PolygonVariable::Rate::Point;
        expected = long(mesh.points.size() - mesh.made.size());
        break;
    case StorageClass::FaceVarying:
    case StorageClass::FaceVertex:
        result.rate = PolygonVariable::Rate::Corner;
        expected = long(mesh.vertexCount);
        break;
    }
    if (variable.count() != expected) {
        reportWrongCount(variable, expected, where, diagnostics);
        return std::nullopt;
    }
    if (result.rate == PolygonVariable::Rate::Point || result.rate == PolygonVariable::Rate::Corner)
        addMadeValues(mesh, result);
    return result;
}

} // namespace candela
