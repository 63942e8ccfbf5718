// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/test_support.h"
#include "world/geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace candela {
namespace {

using namespace geometrytest;

Parameter points(std::vector<float> floats) {
    return parameter("P", StorageClass::Vertex, ValueType::Point, std::move(floats));
}

/// One polygon of one loop over all its points.
PolygonsRecord polygon(int corners) {
    PolygonsRecord record{{1}, {corners}, {}};
    for (int i = 0; i < corners; ++i)
        record.vertices.push_back(i);
    return record;
}

const std::vector<float> squareXy = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0};

TEST(Polygons, NormalIsTheCrossProductOfTheFirstEdges) {
    auto surface = surfaceOf(polygon(4), {points(squareXy)});
    EXPECT_EQ(normalize(at(*surface, 0.3f, 0.3f, 0).Ng), (Vec3{0, 0, 1}));
    EXPECT_EQ(normalize(at(*surface, 0.3f, 0.3f, 1).Ng), (Vec3{0, 0, 1}));
    std::vector<float> reversed = {0, 0, 0, 0, 2, 0, 2, 2, 0, 2, 0, 0};
    surface = surfaceOf(polygon(4), {points(reversed)});
    EXPECT_EQ(normalize(at(*surface, 0.3f, 0.3f, 0).Ng), (Vec3{0, 0, -1}));
}

TEST(Polygons, ShadersSeeObjectSpaceXyAsTextureCoordinates) {
    auto surface = surfaceOf(polygon(4), {points({0, 0, 0, 2, 0, 1, 2, 2, 1, 0, 2, 0})});
    for (std::uint32_t piece : {0, 1}) {
        Point p = at(*surface, 0.2f, 0.5f, piece);
        EXPECT_FLOAT_EQ(p.u, p.P.x);
        EXPECT_FLOAT_EQ(p.v, p.P.y);
        EXPECT_EQ(variable(*surface, "s", 0.2f, 0.5f, piece).value[0], p.P.x);
        EXPECT_EQ(variable(*surface, "t", 0.2f, 0.5f, piece).value[0], p.P.y);
        EXPECT_LT(length(p.dPdu - Vec3{1, 0, 0.5f}), 1e-6f);
        EXPECT_LT(length(p.dPdv - Vec3{0, 1, 0}), 1e-6f);
        EXPECT_FLOAT_EQ(variable(*surface, "s", 0.2f, 0.5f, piece).du[0], 1);
        EXPECT_NEAR(variable(*surface, "s", 0.2f, 0.5f, piece).dv[0], 0, 1e-6);
    }
}

TEST(Polygons, FramesFollowTheNormalWhateverTheTextureCoordinates) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (int i = 0; i < 200; ++i) {
        std::vector<float> p, st;
        for (int k = 0; k < 9; ++k)
            p.push_back(uniform(random));
        for (int k = 0; k < 6; ++k)
            st.push_back(i % 4 == 0 ? 0.5f : uniform(random)); // Every fourth has no area in st.
        auto surface =
            surfaceOf(polygon(3),
                      {points(p), parameter("st", StorageClass::Vertex, ValueType::Float, st, 2)});
        Point q = at(*surface, 0.3f, 0.3f);
        EXPECT_TRUE(isFinite(q.dPdu) && isFinite(q.dPdv));
        Vec3 normal = normalize(cross(normalize(q.dPdu), normalize(q.dPdv)));
        EXPECT_GT(dot(normal, normalize(q.Ng)), 0.999f);
    }
}

TEST(Polygons, DerivativesOfVariablesAreAlongTheFrame) {
    // A variable that is linear in space: its derivative along dPdu is gradient . dPdu.
    const std::vector<float> p = {0, 0, 0, 0, 1, 2, 1, 3, 1}; // mirrored in (x,y)
    const Vec3 gradient{2, -1, 3};
    std::vector<float> values;
    for (int i = 0; i < 3; ++i)
        values.push_back(dot(gradient, {p[3 * i], p[3 * i + 1], p[3 * i + 2]}));
    auto surface =
        surfaceOf(polygon(3),
                  {points(p), parameter("heat", StorageClass::Varying, ValueType::Float, values)});
    Point q = at(*surface, 0.25f, 0.5f);
    Value heat = variable(*surface, "heat", 0.25f, 0.5f);
    EXPECT_NEAR(heat.value[0], dot(gradient, q.P), 1e-5);
    EXPECT_NEAR(heat.du[0], dot(gradient, q.dPdu), 1e-5);
    EXPECT_NEAR(heat.dv[0], dot(gradient, q.dPdv), 1e-5);
}

TEST(Polygons, CarryVariablesOfEveryClass) {
    // Two triangles that share an edge.
    PolygonsRecord mesh{{1, 1}, {3, 3}, {0, 1, 2, 2, 1, 3}};
    auto floats = [](std::string name, StorageClass storage, std::vector<float> values) {
        return parameter(std::move(name), storage, ValueType::Float, std::move(values));
    };
    auto surface = surfaceOf(
        mesh,
        {points({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}), floats("whole", StorageClass::Constant, {5}),
         floats("face", StorageClass::Uniform, {6, 7}),
         floats("point", StorageClass::Varying, {0, 1, 2, 3}),
         floats("vertex", StorageClass::Vertex, {0, 10, 20, 30}),
         floats("corner", StorageClass::FaceVarying, {1, 2, 3, 4, 5, 6}),
         floats("same", StorageClass::FaceVertex, {1, 2, 3, 4, 5, 6}),
         parameter("Np", StorageClass::Uniform, ValueType::Normal, {0, 1, 1, 0, 2, 1})});
    auto get = [&](const char *name, float a, float b, std::uint32_t piece) {
        return variable(*surface, name, a, b, piece).value[0];
    };
    EXPECT_EQ(get("whole", 0.5f, 0.25f, 1), 5);
    EXPECT_EQ(get("face", 0.5f, 0.25f, 0), 6);
    EXPECT_EQ(get("face", 0.5f, 0.25f, 1), 7);
    EXPECT_EQ(get("point", 0.5f, 0.25f, 0), 1);
    EXPECT_EQ(get("point", 0.5f, 0.25f, 1), 2 * 0.25f + 1 * 0.5f + 3 * 0.25f);
    EXPECT_EQ(get("vertex", 0, 1, 1), 30);
    EXPECT_EQ(get("corner", 0, 0, 1), 4);
    EXPECT_EQ(get("corner", 1, 0, 1), 5);
    EXPECT_EQ(get("same", 0, 1, 0), 3);
    EXPECT_EQ(at(*surface, 0.2f, 0.2f, 1).N, (Vec3{0, 2, 1}));
}

TEST(Polygons, InterpolateNormals) {
    auto surface = surfaceOf(polygon(3), {points({0, 0, 0, 1, 0, 0, 0, 1, 0}),
                                          parameter("N", StorageClass::Varying, ValueType::Normal,
                                                    {0, 0, 1, 1, 0, 1, 0, 1, 1})});
    EXPECT_EQ(at(*surface, 0.5f, 0.25f).N, (Vec3{0.5f, 0.25f, 1}));
    EXPECT_EQ(at(*surface, 0.5f, 0.25f).Ng, (Vec3{0, 0, 1}));
}

TEST(Polygons, DiceIsExact) {
    auto surface = surfaceOf(polygon(4), {points(squareXy)});
    DicedMesh mesh = surface->dice({1e-3f, 1e-6f});
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.chordError, 0);
    EXPECT_TRUE(mesh.vertexUv.empty());
    EXPECT_LT(sampledChordError(*surface, mesh), 1e-6);
    EXPECT_FLOAT_EQ(surface->area(), 4);
    EXPECT_EQ(surface->bound().high, (Vec3{2, 2, 0}));
}

TEST(Polygons, HomogeneousPointsAreDivided) {
    auto surface = surfaceOf(polygon(3), {parameter("Pw", StorageClass::Vertex, ValueType::HPoint,
                                                    {0, 0, 0, 1, 4, 0, 0, 2, 0, 9, 0, 3})});
    EXPECT_FLOAT_EQ(surface->area(), 3);
}

using Loop = std::vector<std::array<double, 2>>;

double areaOfLoop(const Loop &loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        auto p = loop[i], q = loop[(i + 1) % loop.size()];
        sum += p[0] * q[1] - p[1] * q[0];
    }
    return std::abs(sum) / 2;
}

/// A star-shaped loop about a centre: never crosses itself.
Loop star(std::mt19937 &random, double x, double y, double radius, int corners) {
    std::uniform_real_distribution<double> uniform(0.25, 1);
    Loop loop;
    for (int i = 0; i < corners; ++i) {
        double angle = 2 * std::numbers::pi * i / corners, r = radius * uniform(random);
        loop.push_back({float(x + r * std::cos(angle)), float(y + r * std::sin(angle))});
    }
    return loop;
}

struct Face {
    PolygonsRecord record;
    std::vector<float> p;

    /// Adds a loop, on a tilted plane, so that no coordinate is that of the drawing.
    void add(const Loop &loop) {
        record.vertexCounts.push_back(int(loop.size()));
        for (auto q : loop) {
            record.vertices.push_back(int(p.size() / 3));
            float x = float(q[0]), y = float(q[1]);
            p.insert(p.end(), {0.6f * x, y, 0.8f * x});
        }
    }
};

double coveredArea(const Surface &surface) { return areaOf(surface.dice({})); }

TEST(Triangulation, CoversRandomPolygonsWithHoles) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 300; ++trial) {
        Face face;
        Loop outside = star(random, 0, 0, 40, 7 + trial % 60);
        for (auto &p : outside) { // Room for the holes within.
            double r = std::hypot(p[0], p[1]), wanted = 20 + r / 2;
            p = {float(p[0] * wanted / r), float(p[1] * wanted / r)};
        }
        if (trial % 2)
            std::ranges::reverse(outside);
        face.add(outside);
        double area = areaOfLoop(outside);
        int holes = trial % 7;
        for (int h = 0; h < holes; ++h) {
            // In rows that line up, so that bridges meet corners of equal height.
            Loop hole = star(random, -6 + 6 * (h % 3), -6 + 6 * (h / 3), 2.5, 3 + (trial + h) % 9);
            if ((trial + h) % 3)
                std::ranges::reverse(hole);
            area -= areaOfLoop(hole);
            face.add(hole);
        }
        face.record.loopCounts = {1 + holes};
        auto surface = surfaceOf(face.record, {points(face.p)});
        ASSERT_TRUE(surface);
        EXPECT_NEAR(coveredArea(*surface) / area, 1, 1e-5) << trial;
        // A disc with n corners and h holes has n + 2h - 2 triangles, all turning one way.
        DicedMesh mesh = surface->dice({});
        EXPECT_EQ(mesh.triangles.size(), face.record.vertices.size() + 2 * holes - 2);
        EXPECT_EQ(borderEdges(mesh), int(face.record.vertices.size()));
        Vec3 along = at(*surface, 0.3f, 0.3f, 0).Ng;
        for (std::uint32_t k = 0; k < mesh.triangles.size(); ++k)
            EXPECT_GT(dot(at(*surface, 0.3f, 0.3f, k).Ng, along), 0);
        Vec3 natural = Vec3{0.8f, 0, -0.6f} * (trial % 2 ? 1.0f : -1.0f);
        EXPECT_GT(dot(along, natural), 0);
    }
}

TEST(Triangulation, TakesCollinearAndRepeatedCorners) {
    // A square with corners on its sides, some twice.
    std::vector<float> p = {0, 0, 0, 1, 0, 0, 2, 0, 0, 2, 0, 0, 2, 1, 0,
                            2, 2, 0, 1, 2, 0, 0, 2, 0, 0, 1, 0, 0, 0, 0};
    auto surface = surfaceOf(polygon(10), {points(p)});
    DicedMesh mesh = surface->dice({});
    EXPECT_FLOAT_EQ(float(areaOf(mesh)), 4);
    EXPECT_EQ(mesh.triangles.size(), 6u);
    EXPECT_EQ(borderEdges(mesh), 8); // Every point of the sides is a corner: no T-junctions.
}

TEST(Triangulation, HolesMayTouch) {
    Face face;
    face.add({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
    face.add({{1, 1}, {3, 1}, {3, 3}, {1, 3}});
    face.add({{3, 3}, {5, 3}, {5, 5}, {3, 5}}); // Shares the corner (3,3).
    face.add({{6, 3}, {8, 4}, {6, 5}});         // Touches the outside from within.
    face.record.loopCounts = {4};
    auto surface = surfaceOf(face.record, {points(face.p)});
    EXPECT_NEAR(coveredArea(*surface), 64 - 4 - 4 - 2, 1e-4);
}

TEST(Triangulation, GridOfHolesAndCombs) {
    Face grid;
    grid.add({{0, 0}, {41, 0}, {41, 41}, {0, 41}});
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) {
            double x = 1 + 2 * i, y = 1 + 2 * j;
            grid.add({{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
        }
    grid.record.loopCounts = {401};
    EXPECT_NEAR(coveredArea(*surfaceOf(grid.record, {points(grid.p)})), 41 * 41 - 400, 1e-2);

    Loop comb{{0, -1}, {1000, -1}};
    for (int i = 999; i >= 0; --i) {
        comb.push_back({i + 0.75, 50});
        comb.push_back({i + 0.25, 0});
    }
    Face teeth;
    teeth.add(comb);
    teeth.record.loopCounts = {1};
    auto surface = surfaceOf(teeth.record, {points(teeth.p)});
    EXPECT_NEAR(coveredArea(*surface) / areaOfLoop(comb), 1, 1e-4);
}

TEST(Triangulation, SurvivesNonsense) {
    std::mt19937 random(11);
    std::uniform_int_distribution<int> coarse(0, 4), corner(0, 11);
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<Vec3> p;
        for (int i = 0; i < 12; ++i)
            p.push_back({float(coarse(random)), float(coarse(random)), 0});
        std::vector<int> a(8), b(4);
        for (auto *loop : {&a, &b})
            for (int &index : *loop)
                index = corner(random);
        const std::span<const int> loops[] = {a, b};
        std::vector<std::array<std::uint32_t, 3>> triangles;
        std::vector<MadeCorner> made;
        triangulate(p, loops, triangles, made);
        EXPECT_LE(made.size(), 66u);
        for (const MadeCorner &corner : made)
            EXPECT_LT(std::max(corner.between[0], corner.between[1]), 12);
        for (const auto &t : triangles)
            EXPECT_LT(std::max({t[0], t[1], t[2]}), 12u + made.size());
    }
}

TEST(BadPolygons, DegenerateFacesAreDroppedAndTheRestKept) {
    PolygonsRecord mesh{{1, 1, 1, 0}, {3, 3, 2}, {0, 1, 2, 0, 0, 1, 0, 1}};
    DiagnosticList diagnostics;
    auto surfaces = makeSurfaces(
        record(mesh, {points({0, 0, 0, 1, 0, 0, 0, 1, 0}),
                      parameter("face", StorageClass::Uniform, ValueType::Float, {1, 2, 3, 4})}),
        {}, diagnostics);
    ASSERT_EQ(surfaces.size(), 1u);
    EXPECT_FLOAT_EQ(surfaces[0]->area(), 0.5f);
    EXPECT_EQ(variable(*surfaces[0], "face", 0.2f, 0.2f).value[0], 1);
    EXPECT_EQ(diagnostics.count(Severity::Warning), 1);
    EXPECT_NE(diagnostics.text().find("test.rib:17: warning: 3 of 4"), std::string::npos);
}

TEST(BadPolygons, AHoleOutsideIsReported) {
    Face face;
    face.add({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
    face.add({{11, 1}, {13, 1}, {13, 3}});
    face.record.loopCounts = {2};
    DiagnosticList diagnostics;
    auto surfaces = makeSurfaces(record(face.record, {points(face.p)}), {}, diagnostics);
    ASSERT_EQ(surfaces.size(), 1u);
    EXPECT_EQ(diagnostics.count(Severity::Warning), 1);
}

TEST(BadPolygons, InconsistentRecordsAreRefused) {
    const std::vector<float> p = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::vector<float> notFinite = p;
    notFinite[4] = NAN;
    auto refused = [](PolygonsRecord mesh, std::vector<Parameter> variables,
                      Severity severity = Severity::Error) {
        DiagnosticList diagnostics;
        EXPECT_TRUE(makeSurfaces(record(mesh, std::move(variables)), {}, diagnostics).empty());
        EXPECT_EQ(diagnostics.count(severity), 1);
        EXPECT_EQ(diagnostics.text().substr(0, 12), "test.rib:17:");
    };
    refused({{1}, {3}, {0, 1, 3}}, {points(p)});
    refused({{1}, {3}, {0, 1, -1}}, {points(p)});
    refused({{1}, {4}, {0, 1, 2}}, {points(p)});
    refused({{2}, {3}, {0, 1, 2}}, {points(p)});
    refused({{-1, 2}, {3}, {0, 1, 2}}, {points(p)});
    refused({{1}, {3}, {0, 1, 2}}, {});
    refused({{1}, {3}, {0, 1, 2}}, {points(notFinite)});
    // No area at all: nothing is lost.
    refused({{1}, {3}, {0, 1, 0}}, {points(p)}, Severity::Warning);
    refused({{}, {}, {}}, {points(p)}, Severity::Warning);
    refused({{1}, {3}, {0, 1, 2}}, {parameter("Pw", StorageClass::Vertex, ValueType::HPoint,
                                              {0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1})});
}

} // namespace
} // namespace candela
