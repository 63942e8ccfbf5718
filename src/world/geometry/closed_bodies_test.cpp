// SPDX-License-Identifier: Apache-2.0
// Bodies of several primitives close where these share a rim; faces that are not flat are whole.
#include "world/geometry/test_support.h"

#include <cmath>
#include <map>
#include <tuple>

namespace candela {
namespace {

using namespace geometrytest;

using Shapes = std::vector<std::shared_ptr<const Surface>>;

/// Edges, by the bits of their ends, that do not have exactly two triangles.
int leaks(const Shapes &body, const DiceRate &rate) {
    using Place = std::tuple<float, float, float>;
    std::map<std::pair<Place, Place>, int> edges;
    for (const auto &surface : body) {
        DicedMesh mesh = surface->dice(rate);
        auto place = [&](std::uint32_t i) {
            Vec3 p = mesh.positions[i];
            return Place{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; // -0 is 0
        };
        for (const auto &t : mesh.triangles)
            for (int k = 0; k < 3; ++k) {
                auto a = place(t[k]), b = place(t[(k + 1) % 3]);
                ++edges[std::minmax(a, b)];
            }
    }
    int open = 0;
    for (const auto &[edge, count] : edges)
        open += count != 2;
    return open;
}

std::shared_ptr<const Surface> bezierPatch(const std::array<Vec3, 4> &corners, float bulge) {
    std::vector<float> p;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            float u = i == 3 ? 1 : i / 3.0f, v = j == 3 ? 1 : j / 3.0f;
            // Sides of a cube bulge as if blown up; the same sums for a point in all of its sides.
            Vec3 flat = (corners[0] * (1 - u) + corners[1] * u) * (1 - v) +
                        (corners[2] * (1 - u) + corners[3] * u) * v;
            for (int axis = 0; axis < 3; ++axis)
                flat[axis] = std::round(flat[axis] * 3) / 3;
            Vec3 round = flat * (1 + bulge * (3 - dot(flat, flat)));
            p.insert(p.end(), {round.x, round.y, round.z});
        }
    PatchMeshRecord mesh;
    mesh.bicubic = true, mesh.uVertices = mesh.vVertices = 4;
    return surfaceOf(mesh, {parameter("P", StorageClass::Vertex, ValueType::Point, p)});
}

/// Each side's (u,v) run differently, so that shared edges are met from both ends.
Shapes cubeOfPatches(float bulge) {
    auto side = [&](Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return bezierPatch({a, b, c, d}, bulge); };
    return {side({-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}),
            side({1, 1, 1}, {-1, 1, 1}, {1, -1, 1}, {-1, -1, 1}),
            side({-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}),
            side({1, -1, -1}, {1, 1, -1}, {1, -1, 1}, {1, 1, 1}),
            side({1, -1, 1}, {1, -1, -1}, {-1, -1, 1}, {-1, -1, -1}),
            side({-1, 1, -1}, {1, 1, -1}, {-1, 1, 1}, {1, 1, 1})};
}

TEST(ClosedBodies, DoNotLeak) {
    for (float r : {1.0f, 0.37f, 123.4f}) {
        auto of = [](ShapeRecord shape) { return surfaceOf(shape); };
        const std::pair<const char *, Shapes> bodies[] = {
            {"can",
             {of(CylinderRecord{r, -r, 2 * r, 360}), of(DiskRecord{-r, r, 360}),
              of(DiskRecord{2 * r, r, 360})}},
            {"can backwards",
             {of(CylinderRecord{r, 2 * r, -r, -360}), of(DiskRecord{-r, r, -360}),
              of(DiskRecord{2 * r, r, -360})}},
            {"cone", {of(ConeRecord{3 * r, r, 360}), of(DiskRecord{0, r, 360})}},
            {"hemisphere", {of(SphereRecord{r, 0, r, 360}), of(DiskRecord{0, r, 360})}},
            {"half spheres", {of(SphereRecord{r, -r, 0, 360}), of(SphereRecord{r, 0, r, 360})}},
            {"dome",
             {of(CylinderRecord{r, -r, 0, 360}), of(SphereRecord{r, 0, r, 360}),
              of(DiskRecord{-r, r, 360})}},
            {"zones",
             {of(SphereRecord{r, -r, -0.0f, 360}), of(SphereRecord{r, 0, 0.3f * r, 360}),
              of(SphereRecord{r, 0.3f * r, r, 360})}},
            {"paraboloid", {of(ParaboloidRecord{r, 0, 2 * r, 360}), of(DiskRecord{2 * r, r, 360})}},
            {"torus",
             {of(TorusRecord{2 * r, r, 0, 180, 360}), of(TorusRecord{2 * r, r, 180, 360, 360})}},
            {"half can",
             {
                 of(CylinderRecord{r, 0, r, 200}),
                 of(CylinderRecord{r, r, 2 * r, 200}),
             }},
        };
        for (const auto &[name, body] : bodies)
            for (float share : {100.0f, 0.1f, 1e-2f, 1.3e-3f}) {
                DiceRate rate{100 * r, share * r};
                if (name == std::string("half can")) {
                    // The rim in the middle closes; four straight sides and two rims are left.
                    int rims = int(body[0]->dice(rate).triangles.size());
                    EXPECT_EQ(leaks(body, rate), rims + 4) << name << " " << r << " " << share;
                } else {
                    EXPECT_EQ(leaks(body, rate), 0) << name << " " << r << " " << share;
                }
            }
    }
}

TEST(ClosedBodies, OfPatchesDoNotLeak) {
    for (float bulge : {0.0f, 0.05f, 0.2f})
        for (float chord : {1.0f, 0.05f, 2e-3f, 1e-4f})
            EXPECT_EQ(leaks(cubeOfPatches(bulge), {1, chord}), 0) << bulge << " " << chord;
}

/// Signed area that triangles of a polygon cover, seen along z.
double coverFromAbove(const DicedMesh &mesh, double &lost) {
    double area = 0;
    lost = 0;
    for (const auto &t : mesh.triangles) {
        Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
        double own = 0.5 * cross(b - a, c - a).z;
        area += own;
        lost += own < -1e-6;
    }
    return area;
}

TEST(FacesThatAreNotFlat, CoverTheirOutlineFromAbove) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (int n = 4; n <= 9; ++n)
        for (int trial = 0; trial < 300; ++trial) {
            float height = std::pow(10.0f, 1.5f * uniform(random));
            std::vector<float> p;
            PolygonsRecord face{{1}, {n}, {}};
            for (int i = 0; i < n; ++i) {
                double angle = 2 * std::numbers::pi * (i + 0.3) / n;
                // One lifted corner, or all of them anywhere.
                float z = trial % 2 ? (i == trial % n ? height : 0) : height * uniform(random);
                p.insert(p.end(), {float(std::cos(angle)), float(std::sin(angle)), z});
                face.vertices.push_back(i);
            }
            auto surface =
                surfaceOf(face, {parameter("P", StorageClass::Vertex, ValueType::Point, p)});
            ASSERT_TRUE(surface) << n << " " << trial;
            double turnedOver;
            double expected = 0.5 * n * std::sin(2 * std::numbers::pi / n);
            EXPECT_NEAR(coverFromAbove(surface->dice({}), turnedOver), expected, 1e-5);
            EXPECT_EQ(turnedOver, 0) << n << " " << trial;
        }
}

TEST(FacesThatAreNotFlat, MakeWholeHeightFields) {
    constexpr int side = 20;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform(-8, 8);
    std::vector<float> p;
    PolygonsRecord field;
    for (int y = 0; y <= side; ++y)
        for (int x = 0; x <= side; ++x)
            p.insert(p.end(), {float(x), float(y), uniform(random)});
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            int corner = y * (side + 1) + x;
            field.loopCounts.push_back(1);
            field.vertexCounts.push_back(4);
            for (int next : {0, 1, side + 2, side + 1})
                field.vertices.push_back(corner + next);
        }
    DicedMesh mesh =
        surfaceOf(field, {parameter("P", StorageClass::Vertex, ValueType::Point, p)})->dice({});
    EXPECT_EQ(mesh.triangles.size(), 2u * side * side);
    double turnedOver;
    EXPECT_NEAR(coverFromAbove(mesh, turnedOver), side * side, 1e-2);
    EXPECT_EQ(turnedOver, 0);
    EXPECT_EQ(borderEdges(mesh), 4 * side);
}

TEST(FacesThatAreNotFlat, ConcaveFlatQuadsKeepTheirNotch) {
    for (int start = 0; start < 4; ++start) {
        const Vec3 dart[] = {{0, 0, 0}, {2, -1, 0}, {0, 3, 0}, {-2, -1, 0}};
        std::vector<float> p;
        for (int i = 0; i < 4; ++i)
            for (int axis = 0; axis < 3; ++axis)
                p.push_back(dart[(start + i) % 4][axis]);
        auto surface = surfaceOf(PolygonsRecord{{1}, {4}, {0, 1, 2, 3}},
                                 {parameter("P", StorageClass::Vertex, ValueType::Point, p)});
        EXPECT_FLOAT_EQ(surface->area(), 6) << start;
    }
}

/// Four cells each twisted by its whole size: the case of a lifted corner near the camera.
TEST(TwistedCells, CostNoMoreThanTheRootOfTheChordError) {
    PatchMeshRecord mesh;
    mesh.uVertices = mesh.vVertices = 3;
    auto surface = surfaceOf(mesh, {parameter("P", StorageClass::Vertex, ValueType::Point,
                                              {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1,
                                               1, 2, 1, 0, 0, 2, 0, 1, 2, 0, 2, 2, 0})});
    for (float chord : {1e-3f, 1e-5f, 2e-7f}) {
        DicedMesh diced = surface->dice({1e9f, chord});
        // Two triangles a cell; the error of n cells of twist 1 is 1 / 4n, which may be 1/64 of the
        // root; and the ladder of counts takes up to half as many again each way.
        double cells = 1.5 * 1.5 * 16 / std::sqrt(chord);
        EXPECT_LE(double(diced.triangles.size()), 4 * 2 * cells) << chord;
        // 4e-6 of the coefficients are rounding.
        EXPECT_LE(diced.chordError, std::max(1.1f * chord, std::sqrt(chord) / 64) + 2e-5f);
        EXPECT_LE(sampledChordError(*surface, diced, 2), diced.chordError);
    }
}

TEST(Extremes, NeitherNanNorEndless) {
    auto check = [](const std::shared_ptr<const Surface> &surface, const std::string &name) {
        if (!surface)
            return;
        for (DiceRate rate :
             {DiceRate{1e-12f, 1e-12f}, DiceRate{1, 0.1f}, DiceRate{1e12f, 1e12f}}) {
            double count = surface->triangleCount(rate);
            EXPECT_LE(count, 2.2e6) << name;
            if (count > 20000)
                continue;
            DicedMesh mesh = surface->dice(rate);
            EXPECT_EQ(count, double(mesh.triangles.size())) << name;
            EXPECT_TRUE(std::isfinite(mesh.chordError)) << name;
            for (Vec3 p : mesh.positions)
                EXPECT_TRUE(isFinite(p)) << name;
        }
        EXPECT_TRUE(std::isfinite(surface->area()) && surface->area() > 0) << name;
        for (float u : {0.0f, 0.4f, 1.0f})
            for (float v : {0.0f, 0.3f, 0.6f}) {
                Vec3 dNdu, dNdv;
                float scale = -1;
                SurfaceAnswer answer;
                answer.dNdu = {&dNdu.x, &dNdu.y, &dNdu.z};
                answer.dNdv = {&dNdv.x, &dNdv.y, &dNdv.z};
                answer.areaScale = &scale;
                std::uint32_t piece = 0;
                surface->evaluate({1, &piece, &u, &v}, answer);
                EXPECT_TRUE(isFinite(dNdu) && isFinite(dNdv) && std::isfinite(scale)) << name;
                Point p = at(*surface, u, v);
                EXPECT_TRUE(isFinite(p.P) && isFinite(p.Ng) && isFinite(p.dPdu)) << name;
            }
    };
    for (float s : {1e-9f, 1e9f}) {
        std::string size = " of " + std::to_string(std::log10(s));
        check(surfaceOf(SphereRecord{s, -s, s, 360}), "sphere" + size);
        check(surfaceOf(ConeRecord{s, s, 360}), "cone" + size);
        check(surfaceOf(CylinderRecord{s, -s, s, 360}), "cylinder" + size);
        check(surfaceOf(HyperboloidRecord{{s, 0, -s}, {s, s, s}, 360}), "hyperboloid" + size);
        check(surfaceOf(ParaboloidRecord{s, 0, s, 360}), "paraboloid" + size);
        check(surfaceOf(DiskRecord{0, s, 360}), "disk" + size);
        check(surfaceOf(TorusRecord{s, s / 2, 0, 360, 360}), "torus" + size);
    }
    // Beside the origin as far as floats resolve a thousandth of them, and not at all.
    for (auto [size, away] : {std::pair{1e-9f, 0.0f}, {1e9f, 0.0f}, {1.0f, 1e4f}, {1.0f, 1e8f}}) {
        std::vector<float> p;
        for (float y : {0.0f, 0.3f, 0.7f, 1.0f})
            for (float x : {0.0f, 0.3f, 0.7f, 1.0f})
                p.insert(p.end(), {away + size * x, away + size * y, away + size * x * y});
        PatchMeshRecord mesh;
        mesh.bicubic = true, mesh.uVertices = mesh.vVertices = 4;
        DiagnosticList diagnostics;
        auto patch = record(mesh, {parameter("P", StorageClass::Vertex, ValueType::Point, p)});
        auto face = record(PolygonsRecord{{1}, {4}, {0, 3, 15, 12}},
                           {parameter("P", StorageClass::Vertex, ValueType::Point, p)});
        for (const auto &made :
             {makeSurfaces(patch, {}, diagnostics), makeSurfaces(face, {}, diagnostics)}) {
            for (const auto &surface : made)
                check(surface, "sheet of " + std::to_string(size) + " at " + std::to_string(away));
            // What cannot be used is said to be.
            EXPECT_TRUE(!made.empty() || diagnostics.count(Severity::Error) > 0);
        }
    }
}

} // namespace
} // namespace candela
