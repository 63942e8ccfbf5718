// SPDX-License-Identifier: Apache-2.0
#include "world/shapes/displaced_dicing.h"

#include "world/shapes/coincident_points.h"
#include "world/shapes/joined_points.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace candela {
namespace {

/// Moves points along the surface's normals by waves of their places.
class Waves final : public Displacement {
public:
    explicit Waves(std::shared_ptr<const Surface> surface, float height = 0.15f)
        : surface_(std::move(surface)), height_(height) {}

    bool movesPoints() const override { return true; }
    bool setsNormals() const override { return false; }
    bool isOfSurface() const override { return false; }
    bool knowsSlopes() const override { return false; }
    float width(Vec3) const override { return 0.01f; }
    void move(const SurfaceQuery &query, Vec3Planes P) const override {
        std::vector<float> normals(3 * std::size_t(query.count));
        float *x = normals.data();
        const Vec3Planes N{x, x + query.count, x + 2 * query.count};
        SurfaceAnswer answer;
        answer.P = P, answer.N = N;
        surface_->evaluate(query, answer);
        for (int k = 0; k < query.count; ++k) {
            const Vec3 p = P.get(k);
            P.set(k, p + normalize(N.get(k)) *
                             (height_ * std::sin(5 * p.x + 3 * p.z) * std::cos(4 * p.y)));
        }
    }
    void displace(const SurfaceQuery &query, const SurfaceAnswer &answer) const override {
        move(query, answer.P);
    }

private:
    std::shared_ptr<const Surface> surface_;
    float height_;
};

std::vector<std::shared_ptr<const Surface>> surfacesOf(ShapeRecord shape,
                                                       std::vector<float> P = {}) {
    auto record = std::make_shared<PrimitiveRecord>();
    record->shape = std::move(shape);
    if (!P.empty())
        record->variables.all.push_back(
            {"P", {StorageClass::Vertex, ValueType::Point, 1}, std::move(P), {}});
    DiagnosticList diagnostics;
    auto surfaces = makeSurfaces(record, {}, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    return surfaces;
}

/// A cube of separate squares, or as one mesh.
std::vector<std::shared_ptr<const Surface>> cube(bool mesh) {
    PolygonsRecord all;
    std::vector<std::shared_ptr<const Surface>> faces;
    std::vector<float> corners;
    for (int k = 0; k < 8; ++k)
        for (int bit : {1, 2, 4})
            corners.push_back(k & bit ? 1 : -1);
    for (int axis = 0; axis < 3; ++axis)
        for (int side : {0, 1}) {
            const int a = 1 << (axis + 1) % 3, b = 1 << (axis + 2) % 3, c = side << axis;
            std::array<int, 4> face = side ? std::array{c, c + a, c + a + b, c + b}
                                           : std::array{c, c + b, c + a + b, c + a};
            all.loopCounts.push_back(1), all.vertexCounts.push_back(4);
            all.vertices.insert(all.vertices.end(), face.begin(), face.end());
            std::vector<float> P;
            for (int k : face)
                P.insert(P.end(), corners.begin() + 3 * k, corners.begin() + 3 * k + 3);
            if (!mesh)
                faces.push_back(surfacesOf(PolygonsRecord{{1}, {4}, {0, 1, 2, 3}}, P)[0]);
        }
    return mesh ? surfacesOf(all, corners) : faces;
}

struct Diced {
    std::vector<Shape> shapes;
    std::vector<RayShape> meshes;
};

/// `heights`: of the waves, in turn.
Diced diced(const std::vector<std::shared_ptr<const Surface>> &surfaces, float edge,
            double most = 1e6, const std::vector<float> &heights = {0.15f}) {
    Diced result;
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
        result.shapes.push_back(*makeShape(surfaces[k], scaling(1.5f, 1, -0.7f)));
        result.shapes.back().displacement =
            std::make_shared<Waves>(surfaces[k], heights[k % heights.size()]);
    }
    std::vector<DisplacedDicing> dicings;
    for (Shape &shape : result.shapes)
        dicings.push_back({&shape, shape.surface->dice({10, 0.02f}), edge});
    result.meshes = diceDisplaced(dicings, nullptr, most);
    return result;
}

using Place = std::array<float, 3>;

/// Edges by where they end: how many triangles run along each one way, less those that run the
/// other way. Where all is closed nothing is left.
int openEdges(const std::vector<RayShape> &meshes) {
    std::map<std::pair<Place, Place>, int> edges;
    for (const RayShape &mesh : meshes)
        for (const auto &t : mesh.triangles)
            for (int k = 0; k < 3; ++k) {
                const Vec3 a = mesh.positions[t[k]], b = mesh.positions[t[(k + 1) % 3]];
                const Place from{a.x, a.y, a.z}, to{b.x, b.y, b.z};
                if (from < to)
                    ++edges[{from, to}];
                else if (to < from)
                    --edges[{to, from}];
            }
    int open = 0;
    for (const auto &[edge, count] : edges)
        open += count != 0;
    return open;
}

float longestEdge(const std::vector<RayShape> &meshes) {
    float longest = 0;
    for (const RayShape &mesh : meshes)
        for (const auto &t : mesh.triangles)
            for (int k = 0; k < 3; ++k)
                longest = std::max(longest,
                                   length(mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]));
    return longest;
}

TEST(DisplacedDicing, LeavesNoCracks) {
    const std::pair<const char *, std::vector<std::shared_ptr<const Surface>>> bodies[] = {
        {"sphere", surfacesOf(SphereRecord{1, -1, 1, 360})},
        {"torus", surfacesOf(TorusRecord{1, .4f, 0, 360, 360})},
        {"cube of squares", cube(false)},
        {"cube as a mesh", cube(true)},
    };
    for (const auto &[name, surfaces] : bodies) {
        SCOPED_TRACE(name);
        const Diced result = diced(surfaces, 0.06f);
        EXPECT_EQ(openEdges(result.meshes), 0);
        // Where faces that go two ways are joined a step remains, around which it ends.
        const bool isSmooth = surfaces.size() == 1 && surfaces[0]->triangleCount({1, 1}) > 12;
        EXPECT_LE(longestEdge(result.meshes), isSmooth ? 0.06f : 0.2f);
        EXPECT_GT(longestEdge(result.meshes), 0.03f);
        std::size_t triangles = 0;
        for (const RayShape &mesh : result.meshes)
            triangles += mesh.triangles.size();
        EXPECT_LT(triangles, 150000u);
    }
}

/// Bodies of one form in one place are what each would be alone.
TEST(DisplacedDicing, LetsBodiesInOnePlaceGoApart) {
    const auto sphere = surfacesOf(SphereRecord{1, -1, 1, 360})[0];
    const auto torus = surfacesOf(TorusRecord{1, .4f, 0, 360, 360})[0];
    const auto square = surfacesOf(PolygonsRecord{{1}, {4}, {0, 1, 2, 3}},
                                   {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0})[0];
    for (const auto &surface : {sphere, torus, square})
        for (const std::vector<float> &heights :
             {std::vector<float>{.3f, .05f}, {.05f, .05f}, {-.2f, .2f, .1f}}) {
            const std::vector<std::shared_ptr<const Surface>> all(heights.size(), surface);
            const Diced together = diced(all, 0.1f, 1e6, heights);
            for (std::size_t k = 0; k < heights.size(); ++k) {
                const Diced alone = diced({surface}, 0.1f, 1e6, {heights[k]});
                const auto &expected = alone.meshes[0].positions;
                const auto &positions = together.meshes[k].positions;
                ASSERT_EQ(positions.size(), expected.size()) << k;
                for (std::size_t i = 0; i < positions.size(); ++i)
                    ASSERT_LE(length(positions[i] - expected[i]), 1e-6f) << k;
            }
        }
}

/// Whoever shares no more than a rim is joined there, however differently they move.
TEST(DisplacedDicing, JoinsRimsOfWhatMovesDifferently) {
    EXPECT_EQ(openEdges(diced(cube(false), 0.06f, 1e6, {.15f, .05f, -.1f}).meshes), 0);
}

TEST(JoinedPoints, KeepApartWhatSharesMoreThanRims) {
    using Triangles = std::vector<std::array<std::uint32_t, 3>>;
    using Points = std::vector<std::uint32_t>;
    const auto vertices = [](std::initializer_list<std::uint32_t> shapes,
                             std::initializer_list<std::uint32_t> places) {
        std::vector<PlacedVertex> all;
        for (std::size_t k = 0; k < shapes.size(); ++k)
            all.push_back({shapes.begin()[k], places.begin()[k]});
        return all;
    };
    // Two triangles side by side.
    EXPECT_EQ(joinedPoints(vertices({0, 0, 0, 1, 1, 1}, {0, 1, 2, 2, 1, 3}),
                           Triangles{{0, 1, 2}, {3, 4, 5}}),
              (Points{0, 1, 2, 2, 1, 3}));
    // Two in one place, and a third at the rim of both: it goes with the first.
    EXPECT_EQ(joinedPoints(vertices({0, 0, 0, 1, 1, 1, 2, 2, 2}, {0, 1, 2, 1, 0, 2, 2, 1, 3}),
                           Triangles{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}),
              (Points{0, 1, 2, 3, 4, 5, 2, 1, 6}));
    // More in one place than are told apart pair by pair.
    std::vector<PlacedVertex> many;
    Triangles triangles;
    for (std::uint32_t shape = 0; shape < 100; ++shape) {
        const auto first = std::uint32_t(many.size());
        triangles.push_back({first, first + 1, first + 2});
        for (std::uint32_t place : {0u, 1u, 2u})
            many.push_back({shape, place});
    }
    const Points points = joinedPoints(many, triangles);
    for (std::uint32_t k = 0; k < points.size(); ++k)
        EXPECT_EQ(points[k], k);
}

TEST(DisplacedDicing, StaysClosedWithinTheBudget) {
    const Diced result = diced(cube(false), 0.001f, 20000);
    std::size_t triangles = 0;
    for (const RayShape &mesh : result.meshes)
        triangles += mesh.triangles.size();
    EXPECT_LE(triangles, 20000u);
    EXPECT_GT(triangles, 10000u);
    EXPECT_EQ(openEdges(result.meshes), 0);
}

TEST(DisplacedDicing, NamesPointsOfTheSurface) {
    const Diced result = diced(surfacesOf(SphereRecord{1, -1, 1, 360}), 0.05f);
    const Surface &surface = *result.shapes[0].surface;
    const Box3 bound = surface.bound();
    const Matrix4 &outerFromShape = result.shapes[0].outerFromShape;
    for (std::uint32_t k = 0; k < result.shapes[0].elements; k += 37) {
        const float u = 0.25f, v = 0.5f;
        Vec3 P, Ng;
        SurfaceAnswer answer;
        answer.P = {&P.x, &P.y, &P.z}, answer.Ng = {&Ng.x, &Ng.y, &Ng.z};
        surface.evaluate({1, &k, &u, &v}, answer);
        const auto [a, b, c] = result.meshes[0].triangles[k];
        const auto &at = result.meshes[0].positions;
        const Vec3 met = at[a] * 0.25f + at[b] * 0.25f + at[c] * 0.5f;
        EXPECT_LE(length(transformPoint(outerFromShape, P) - met), 1e-6f);
        EXPECT_GE(bound.high.x + 1e-2f, P.x);
        EXPECT_GT(dot(normalize(Ng), normalize(P)), 0.3f); // Outward, if at a slant.
    }
}

TEST(CoincidentPoints, AreThoseThatRoundingMovesApart) {
    const std::vector<Vec3> points{{1, 2, 3},          {1, 2, 3.0000005f}, {1, 2, 3.0001f},
                                   {0, 0, 0},          {0, 0, 1e-3f},      {-1, 2, 3},
                                   {1e5f, 0, 0},       {1e5f, 0, 0.01f},   {1e5f, 0, 1},
                                   {3.9999998f, 0, 0}, {4, 0, 0}};
    EXPECT_EQ(placesOf(points), (std::vector<std::uint32_t>{0, 0, 1, 2, 3, 4, 5, 5, 6, 7, 7}));
}

} // namespace
} // namespace candela
