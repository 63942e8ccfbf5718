// SPDX-License-Identifier: Apache-2.0
// Loop's subdivision surfaces against refinement by hand.
#include "world/geometry/loop_refinement.h"
#include "world/geometry/test_support.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace candela {
namespace {

using namespace geometrytest;

struct Mesh {
    const char *name;
    SubdivisionRecord faces;
    std::vector<float> points;
};

Mesh mesh(const char *name, std::vector<int> vertices, std::vector<float> points) {
    Mesh result{name, {}, std::move(points)};
    result.faces.scheme = SubdivisionRecord::Scheme::Loop;
    result.faces.interpolateBoundary = 2;
    result.faces.vertexCounts.assign(vertices.size() / 3, 3);
    result.faces.vertices = std::move(vertices);
    return result;
}

Mesh tetrahedron() {
    return mesh("tetrahedron", {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3},
                {1, 1, 1, -1, -1, 1, -1, 1, -1, 1.5f, -1, -1});
}

Mesh octahedron() {
    return mesh("octahedron",
                {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5},
                {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1});
}

/// A sheet with corners, a boundary and vertices of all kinds within.
Mesh sheet() {
    std::vector<int> vertices;
    std::vector<float> points;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 5; ++i) {
            points.insert(points.end(), {float(i) + 0.3f * float(j % 2), float(j),
                                         0.6f * std::sin(1.7f * float(i) + float(j * j))});
            const int at = 5 * j + i;
            if (i < 4 && j < 3 && (i + j) % 3 == 0)
                vertices.insert(vertices.end(), {at, at + 1, at + 5, at + 1, at + 6, at + 5});
            else if (i < 4 && j < 3)
                vertices.insert(vertices.end(), {at, at + 1, at + 6, at, at + 6, at + 5});
        }
    return mesh("sheet", vertices, points);
}

std::vector<Mesh> meshes() {
    std::vector<Mesh> all{tetrahedron(), octahedron(), sheet()};
    Mesh creased = octahedron();
    creased.name = "creased octahedron";
    creased.faces.creases = {{{0, 2, 1, 3, 0}, 10}};
    all.push_back(creased);
    Mesh cornered = creased;
    cornered.name = "octahedron with corners";
    cornered.faces.corners = {{0, 10}, {4, 10}};
    all.push_back(cornered);
    Mesh twice = octahedron();
    twice.name = "octahedron, sharp twice";
    twice.faces.creases = {{{0, 2, 1, 3, 0}, 2}};
    all.push_back(twice);
    Mesh corners = sheet();
    corners.name = "sheet with corners";
    corners.faces.interpolateBoundary = 1;
    all.push_back(corners);
    return all;
}

std::shared_ptr<const Surface> made(const Mesh &mesh, std::vector<Parameter> more = {}) {
    more.push_back(parameter("P", StorageClass::Vertex, ValueType::Point, mesh.points));
    return surfaceOf(mesh.faces, std::move(more));
}

/// Loop's rules (1987), with creases and corners as Hoppe and others have them (1994), written down
/// once more. Vertices of two sharp edges lie on a crease; of more, or none's end, they are
/// corners.
struct ByHand {
    using Edge = std::pair<int, int>;
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> faces;
    std::map<Edge, float> sharp;
    std::set<int> corners;

    static Edge edge(int a, int b) { return std::minmax(a, b); }

    explicit ByHand(const Mesh &mesh) {
        for (std::size_t i = 0; i < mesh.points.size(); i += 3)
            points.push_back({mesh.points[i], mesh.points[i + 1], mesh.points[i + 2]});
        const auto &v = mesh.faces.vertices;
        std::map<int, int> facesOf;
        for (std::size_t k = 0; k < v.size(); k += 3) {
            faces.push_back({v[k], v[k + 1], v[k + 2]});
            for (int vertex : faces.back())
                ++facesOf[vertex];
        }
        for (const auto &[e, opposite] : opposites())
            if (opposite.size() == 1)
                sharp[e] = INFINITY;
        for (const auto &crease : mesh.faces.creases)
            for (std::size_t i = 0; i + 1 < crease.vertices.size(); ++i)
                sharp[edge(crease.vertices[i], crease.vertices[i + 1])] =
                    crease.sharpness < 10 ? crease.sharpness : INFINITY;
        for (const auto &corner : mesh.faces.corners)
            corners.insert(corner.vertex);
        if (mesh.faces.interpolateBoundary == 1)
            for (const auto &[vertex, count] : facesOf)
                if (count == 1)
                    corners.insert(vertex);
    }

    std::map<Edge, std::vector<int>> opposites() const {
        std::map<Edge, std::vector<int>> result;
        for (const auto &f : faces)
            for (int k = 0; k < 3; ++k)
                result[edge(f[k], f[(k + 1) % 3])].push_back(f[(k + 2) % 3]);
        return result;
    }

    /// What a vertex becomes: itself, on a crease with two neighbours, or among all of them.
    template <class Crease, class Smooth>
    std::vector<Vec3> moved(const Crease &onCrease, const Smooth &smooth) const {
        std::map<int, Vec3> sum, sharpSum;
        std::map<int, int> valence, sharpEdges;
        for (const auto &[e, opposite] : opposites())
            for (auto [a, b] : {std::pair(e.first, e.second), std::pair(e.second, e.first)}) {
                sum[a] += points[b], ++valence[a];
                if (sharp.contains(e))
                    sharpSum[a] += points[b], ++sharpEdges[a];
            }
        std::vector<Vec3> result = points;
        for (const auto &[a, n] : valence) {
            if (corners.contains(a) || sharpEdges[a] > 2)
                continue;
            result[a] = sharpEdges[a] == 2 ? onCrease(points[a], sharpSum[a])
                                           : smooth(points[a], sum[a], float(n));
        }
        return result;
    }

    static float beta(float n) {
        const double inner = 3 / 8. + std::cos(2 * std::numbers::pi / n) / 4;
        return float((5 / 8. - inner * inner) / n);
    }

    void refine() {
        ByHand finer = *this;
        finer.points =
            moved([](Vec3 p, Vec3 sum) { return p * 0.75f + sum * 0.125f; },
                  [](Vec3 p, Vec3 sum, float n) { return p * (1 - n * beta(n)) + sum * beta(n); });
        finer.faces.clear(), finer.sharp.clear();
        std::map<Edge, int> middle;
        for (const auto &[e, opposite] : opposites()) {
            const Vec3 ends = points[e.first] + points[e.second];
            const auto crease = sharp.find(e);
            middle[e] = int(finer.points.size());
            finer.points.push_back(crease != sharp.end()
                                       ? ends * 0.5f
                                       : ends * 0.375f +
                                             (points[opposite[0]] + points[opposite[1]]) * 0.125f);
            if (crease != sharp.end() && crease->second > 1)
                for (int end : {e.first, e.second})
                    finer.sharp[edge(end, middle[e])] = crease->second - 1;
        }
        for (const auto &[a, b, c] : faces) {
            const int ab = middle[edge(a, b)], bc = middle[edge(b, c)], ca = middle[edge(c, a)];
            for (const auto &part : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
                finer.faces.push_back(part);
        }
        *this = std::move(finer);
    }

    /// Where vertices go in the end, once creases are sharp for ever or gone.
    std::vector<Vec3> limits() const {
        return moved([](Vec3 p, Vec3 sum) { return p * (2 / 3.0f) + sum / 6.0f; },
                     [](Vec3 p, Vec3 sum, float n) {
                         const float share = 1 / (3 / (8 * beta(n)) + n);
                         return p * (1 - n * share) + sum * share;
                     });
    }
};

/// The surface's vertices are the limits of those of the mesh that is refined as often.
TEST(LoopSurfaces, AreWhereRefinementByHandEnds) {
    for (const Mesh &mesh : meshes()) {
        const auto surface = made(mesh);
        ByHand byHand(mesh);
        const int levels = LoopRefinement::levelsFor(mesh.faces);
        ASSERT_EQ(levels, 6);
        EXPECT_EQ(surface->domain().pieces, byHand.faces.size() << (2 * levels)) << mesh.name;
        std::vector<Vec3> there = surface->dice({1e9f, 1e9f}).positions;
        std::ranges::sort(there, {}, &Vec3::x);
        for (int level = 0; level < 3; ++level)
            byHand.refine();
        double farthest = 0;
        for (Vec3 p : byHand.limits()) {
            double nearest = INFINITY;
            auto at = std::ranges::lower_bound(there, p.x - 1e-3f, {}, &Vec3::x);
            for (; at != there.end() && at->x < p.x + 1e-3f; ++at)
                nearest = std::min(nearest, double(length(*at - p)));
            farthest = std::max(farthest, nearest);
        }
        EXPECT_LT(farthest, 3e-6) << mesh.name;
    }
}

/// The normals of vertices are those of the triangles around them, but across creases.
TEST(LoopSurfaces, HaveTheLimitsNormals) {
    for (const Mesh &mesh : meshes()) {
        const auto surface = made(mesh);
        const auto isNearTip = [&](Vec3 p) {
            return std::ranges::any_of(mesh.faces.corners, [&](const auto &corner) {
                const float *tip = &mesh.points[std::size_t(3 * corner.vertex)];
                return length(p - Vec3{tip[0], tip[1], tip[2]}) < 0.5f;
            });
        };
        for (std::uint32_t piece = 0; piece < surface->domain().pieces; ++piece) {
            const Point corners[] = {at(*surface, 0, 0, piece), at(*surface, 1, 0, piece),
                                     at(*surface, 0, 1, piece)};
            // Corners draw spikes, which triangles go round in a few steps.
            if (std::ranges::any_of(corners, isNearTip, &Point::P))
                continue;
            for (const Point &p : corners)
                ASSERT_GT(dot(normalize(p.Ng), normalize(p.N)), 0.98) << mesh.name << " " << piece;
        }
    }
    // By symmetry, at its corners.
    const auto ball = made(octahedron());
    for (std::uint32_t piece = 0; piece < ball->domain().pieces; ++piece) {
        const Point p = at(*ball, 0, 0, piece);
        EXPECT_GT(dot(p.P, p.N), 0);
        if (std::max({std::abs(p.P.x), std::abs(p.P.y), std::abs(p.P.z)}) > length(p.P) - 1e-6f) {
            EXPECT_NEAR(dot(normalize(p.N), normalize(p.P)), 1, 1e-6);
        }
    }
}

TEST(LoopSurfaces, AreTheSameTinyAndHuge) {
    for (float size : {1e-6f, 1e-3f, 1e6f, 1e9f}) {
        Mesh ball = octahedron();
        for (float &x : ball.points)
            x *= size;
        const auto surface = made(ball), one = made(octahedron());
        EXPECT_NEAR(surface->area() / size / size, one->area(), 1e-4);
        for (std::uint32_t piece = 0; piece < surface->domain().pieces; piece += 97) {
            const Vec3 N = normalize(at(*surface, 0.3f, 0.3f, piece).N);
            EXPECT_GT(dot(N, normalize(at(*one, 0.3f, 0.3f, piece).N)), 0.99999f) << size;
        }
    }
    Mesh beyond = octahedron();
    for (float &x : beyond.points)
        x *= 3e38f;
    DiagnosticList diagnostics;
    EXPECT_TRUE(makeSurfaces(record(beyond.faces, {parameter("P", StorageClass::Vertex,
                                                             ValueType::Point, beyond.points)}),
                             {}, diagnostics)
                    .empty());
    EXPECT_NE(diagnostics.text().find("too large or too small"), std::string::npos)
        << diagnostics.text();
}

TEST(LoopSurfaces, SharpAllOverAreWhatTheyWere) {
    Mesh sharp = tetrahedron();
    sharp.faces.creases = {{{0, 1, 2, 0}, 10}, {{0, 3}, 10}, {{1, 3}, 11}, {{2, 3}, 1e9f}};
    const auto surface = made(sharp);
    ByHand flat(sharp);
    double area = 0;
    for (const auto &[a, b, c] : flat.faces)
        area += length(cross(flat.points[b] - flat.points[a], flat.points[c] - flat.points[a])) / 2;
    EXPECT_NEAR(surface->area(), area, 1e-5 * area);
    for (std::uint32_t piece = 0; piece < surface->domain().pieces; ++piece) {
        const Point p = at(*surface, 0, 0, piece);
        EXPECT_NEAR(dot(normalize(p.Ng), normalize(p.N)), 1, 1e-5);
    }
}

TEST(LoopSurfaces, LeaveOutHolesAndBoundariesThatOnlySupport) {
    Mesh holed = octahedron();
    holed.faces.holes = {3, 5};
    EXPECT_EQ(made(holed)->domain().pieces, 6u << 12);
    Mesh supported = sheet();
    supported.faces.interpolateBoundary = 0;
    const auto within = made(supported)->domain().pieces;
    EXPECT_GT(within, 0u);
    EXPECT_LT(within, made(sheet())->domain().pieces);
    EXPECT_EQ(within % (1u << 12), 0u);
}

TEST(LoopSurfaces, VariablesOfAllClasses) {
    const Mesh body = octahedron();
    std::vector<float> x, xOfCorners, face, corner;
    for (std::size_t i = 0; i < body.points.size(); i += 3)
        x.push_back(body.points[i]);
    for (int i = 0; i < 24; ++i) {
        corner.push_back(float(100 + i));
        xOfCorners.push_back(x[std::size_t(body.faces.vertices[std::size_t(i)])]);
    }
    for (int i = 0; i < 8; ++i)
        face.push_back(float(10 * i));
    const auto of = [](const char *name, StorageClass storage, std::vector<float> values) {
        return parameter(name, storage, ValueType::Float, std::move(values));
    };
    Mesh smooth = body;
    smooth.faces.faceVaryingBoundary = 1;
    for (const Mesh *mesh : {&body, static_cast<const Mesh *>(&smooth)}) {
        const bool isSmooth = mesh == &smooth;
        const auto surface = made(
            *mesh, {of("one", StorageClass::Constant, {5}), of("face", StorageClass::Uniform, face),
                    of("even", StorageClass::Varying, x), of("x", StorageClass::Vertex, x),
                    of("corner", StorageClass::FaceVarying, corner),
                    of("joined", StorageClass::FaceVarying, xOfCorners),
                    of("loose", StorageClass::FaceVertex, xOfCorners)});
        const std::uint32_t parts = 1u << 12;
        for (std::uint32_t piece = 0; piece < 8 * parts; piece += 37) {
            const Point p = at(*surface, 0, 0, piece);
            const auto value = [&](const char *name) {
                return variable(*surface, name, 0, 0, piece).value[0];
            };
            const std::size_t of = piece / parts;
            const float s = value("s"), t = value("t");
            const float *xs = &xOfCorners[3 * of];
            const float linear = xs[0] + s * (xs[1] - xs[0]) + t * (xs[2] - xs[0]);
            EXPECT_EQ(value("one"), 5);
            EXPECT_EQ(value("face"), float(10 * of));
            EXPECT_NEAR(value("even"), linear, 1e-6);
            EXPECT_NEAR(value("x"), p.P.x, 1e-6);
            EXPECT_NEAR(value("loose"), p.P.x, 1e-6);
            EXPECT_NEAR(value("joined"), isSmooth ? p.P.x : linear, 1e-6);
            if (!isSmooth) {
                EXPECT_NEAR(value("corner"), float(100 + 3 * of) + s + 2 * t, 1e-4);
            }
        }
    }
    // Normals of the user's are taken as they are.
    const auto own =
        made(body, {parameter("N", StorageClass::Constant, ValueType::Normal, {0, 0, 1})});
    EXPECT_EQ(at(*own, 0.2f, 0.3f, 777).N.z, 1);
}

TEST(LoopSurfaces, OfFacesThatAreNoTrianglesAreCutAndSaySo) {
    SubdivisionRecord faces;
    faces.scheme = SubdivisionRecord::Scheme::Loop;
    faces.interpolateBoundary = 1;
    faces.vertexCounts = {4, 3};
    faces.vertices = {0, 1, 2, 3, 1, 4, 2};
    const std::vector<float> corners{0, 1, 2, 3, 4, 5, 6};
    DiagnosticList diagnostics;
    const auto surfaces = makeSurfaces(
        record(faces, {parameter("P", StorageClass::Vertex, ValueType::Point,
                                 {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0}),
                       parameter("x", StorageClass::FaceVarying, ValueType::Float, corners)}),
        {}, diagnostics);
    EXPECT_NE(diagnostics.text().find("1 faces of the subdivision mesh have more than three"),
              std::string::npos)
        << diagnostics.text();
    ASSERT_EQ(surfaces.size(), 1u);
    EXPECT_NEAR(surfaces[0]->area(), 1.5, 0.3);
    EXPECT_NEAR(variable(*surfaces[0], "x", 0, 0, 2 << 12).value[0], 4, 1e-4);
}

/// Large meshes are split less, and semisharp creases more.
TEST(LoopSurfaces, AreSplitAsOftenAsTheyAreSmall) {
    SubdivisionRecord faces;
    const auto levels = [&](std::size_t count) {
        faces.vertexCounts.assign(count, 3);
        return LoopRefinement::levelsFor(faces);
    };
    EXPECT_EQ(levels(1), 6);
    EXPECT_EQ(levels(1000), 4);
    EXPECT_EQ(levels(100000), 1);
    EXPECT_EQ(levels(10000000), 0);
    faces.creases = {{{0, 1}, 2.5f}};
    EXPECT_EQ(levels(10000), 3);
    EXPECT_EQ(levels(100000), 2);
    EXPECT_EQ(levels(10000000), 0);
}

} // namespace
} // namespace candela
