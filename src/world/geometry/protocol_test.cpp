// SPDX-License-Identifier: Apache-2.0
// What every surface promises, over all kinds of them.
#include "world/geometry/test_support.h"

#include <cmath>

namespace candela {
namespace {

using namespace geometrytest;

struct Case {
    std::string name;
    std::shared_ptr<const Surface> surface;
    bool hasNormals = false; ///< Given by the user.
};

std::vector<float> bumpySheet(int nu, int nv, bool weights) {
    std::vector<float> p;
    for (int j = 0; j < nv; ++j)
        for (int i = 0; i < nu; ++i) {
            float w = weights ? 1 + 0.3f * float((i + 2 * j) % 3) : 1.0f;
            float z = 0.35f * std::sin(2.0f * i + j) * std::cos(1.3f * j);
            for (float x : {i * w, (j + 0.2f * z) * w, z * w})
                p.push_back(x);
            if (weights)
                p.push_back(w);
        }
    return p;
}

std::shared_ptr<const Surface> patch(const BasisRecord &basis, bool bicubic, int nu, int nv,
                                     bool rational) {
    Attributes attributes;
    attributes.uBasis = attributes.vBasis = basis;
    PatchMeshRecord mesh;
    mesh.bicubic = bicubic, mesh.uVertices = nu, mesh.vVertices = nv;
    auto points =
        parameter(rational ? "Pw" : "P", StorageClass::Vertex,
                  rational ? ValueType::HPoint : ValueType::Point, bumpySheet(nu, nv, rational));
    return surfaceOf(mesh, {points}, attributes);
}

struct Stroke {
    std::string name;
    ShapeRecord shape;
    std::vector<Parameter> variables;
    bool isSpline = false, hasNormals = false;
};

std::vector<Stroke> strokes() {
    auto vertices = [](int count, auto place) {
        std::vector<float> p;
        for (int i = 0; i < count; ++i)
            for (float x : place(float(i)))
                p.push_back(x);
        return parameter("P", StorageClass::Vertex, ValueType::Point, p);
    };
    auto helix = [](float i) { return std::array{std::cos(i), std::sin(i), 0.4f * i}; };
    auto widths = [](StorageClass storage, std::vector<float> values) {
        return parameter(storage == StorageClass::Constant ? "constantwidth" : "width", storage,
                         ValueType::Float, std::move(values));
    };
    const auto even = widths(StorageClass::Constant, {0.3f});
    const auto facing = parameter("N", StorageClass::Vertex, ValueType::Normal,
                                  {0, 0, 1, 0.3f, 0, 1, 0.6f, 0.2f, 1, 1, 0, 1});
    const auto turned = parameter("N", StorageClass::Vertex, ValueType::Normal,
                                  {0, 0, 1, 0.3f, 0, 1, 0.6f, 0.2f, 1});
    auto gentle = [](float i) { return std::array{i, 0.3f * std::sin(i), 0.2f * i * i}; };
    return {
        {"tube", CurvesRecord{true, false, {4}}, {vertices(4, gentle), even}},
        {"tube of a spline", CurvesRecord{true, false, {6}}, {vertices(6, helix), even}, true},
        {"tube that closes",
         CurvesRecord{true, true, {6}},
         {vertices(6,
                   [](float i) {
                       return std::array{std::cos(i * 1.0472f), std::sin(i * 1.0472f), 0.0f};
                   }),
          even},
         true},
        {"tube of two that taper",
         CurvesRecord{true, false, {4, 7}},
         {vertices(11,
                   [](float i) {
                       return std::array{i, 0.1f * i * i, float(i > 3)};
                   }),
          widths(StorageClass::Varying, {0.5f, 0.1f, 0.4f, 0.2f, 0.05f})}},
        {"tube of lines",
         CurvesRecord{false, false, {4}},
         {vertices(4,
                   [](float i) {
                       return std::array{i, 0.1f * i * (3 - i), 0.0f};
                   }),
          even}},
        {"tube that is slender",
         CurvesRecord{true, false, {4}},
         {vertices(4, gentle), widths(StorageClass::Constant, {0.004f})}},
        {"tube whose normals are nothing",
         CurvesRecord{true, false, {4}},
         {vertices(4, gentle), even,
          parameter("N", StorageClass::Constant, ValueType::Normal, {0, 0, 0})}},
        {"ribbon",
         CurvesRecord{true, false, {4}},
         {vertices(4, gentle), even, facing},
         false,
         true},
        {"points",
         PointsRecord{3},
         {vertices(3, gentle), widths(StorageClass::Varying, {1, 0.5f, 2})}},
        {"points with N", PointsRecord{3}, {vertices(3, gentle), even, turned}, false, true},
    };
}

std::vector<Case> allCases() {
    const BasisRecord bSpline{{-1.f / 6, 3.f / 6, -3.f / 6, 1.f / 6, 3.f / 6, -6.f / 6, 3.f / 6, 0,
                               -3.f / 6, 0, 3.f / 6, 0, 1.f / 6, 4.f / 6, 1.f / 6, 0},
                              1};
    const BasisRecord catmullRom{
        {-0.5f, 1.5f, -1.5f, 0.5f, 1, -2.5f, 2, -0.5f, -0.5f, 0, 0.5f, 0, 0, 1, 0, 0}, 1};
    auto normals = parameter("N", StorageClass::Varying, ValueType::Normal,
                             {0, 0, 1, 1, 0, 2, 0, 1, 1, 0.5f, 0, 1});
    std::vector<Case> cases;
    auto add = [&](std::string name, std::shared_ptr<const Surface> surface, bool given = false) {
        cases.push_back({std::move(name), std::move(surface), given});
    };
    const std::pair<const char *, ShapeRecord> quadrics[] = {
        {"sphere", SphereRecord{1.5f, -1.5f, 1.5f, 360}},
        {"sphere part", SphereRecord{1.5f, -0.4f, 1.1f, 200}},
        {"sphere backwards", SphereRecord{1.5f, -1.5f, 1.5f, -130}},
        {"sphere inside out", SphereRecord{-1.5f, -1.5f, 1.5f, 360}},
        {"sphere upside down", SphereRecord{1.5f, 1.1f, -0.4f, 360}},
        {"cone", ConeRecord{2, 0.5f, 360}},
        {"cone inside out", ConeRecord{2, -0.5f, 75}},
        {"cylinder", CylinderRecord{0.7f, -1, 2, 360}},
        {"cylinder part", CylinderRecord{-0.7f, 2, -1, 95}},
        {"hyperboloid", HyperboloidRecord{{1, -0.5f, -1}, {0.6f, 0.9f, 1.4f}, 360}},
        {"hyperboloid part", HyperboloidRecord{{1, -0.5f, -1}, {0.6f, 0.9f, 1.4f}, -140}},
        {"annulus", HyperboloidRecord{{0.4f, 0, 1}, {1, 0.3f, 1}, 360}},
        {"paraboloid", ParaboloidRecord{0.8f, 0, 1.2f, 360}},
        {"paraboloid part", ParaboloidRecord{-0.8f, 0.3f, 1.2f, 210}},
        {"paraboloid down", ParaboloidRecord{0.8f, -0.3f, -1.2f, 360}},
        {"disk", DiskRecord{-0.3f, 1.1f, 360}},
        {"disk part", DiskRecord{-0.3f, -1.1f, 50}},
        {"torus", TorusRecord{2, 0.6f, 0, 360, 360}},
        {"torus part", TorusRecord{2, -0.6f, 30, 250, 100}},
        {"torus inside out", TorusRecord{-2, 0.6f, 0, 360, -360}},
    };
    for (const auto &[name, shape] : quadrics)
        add(name, surfaceOf(shape));
    add("sphere with N", surfaceOf(SphereRecord{1, -0.5f, 0.8f, 300}, {normals}), true);
    add("paraboloid with N", surfaceOf(ParaboloidRecord{1, 0.2f, 1, 360}, {normals}), true);
    for (bool rational : {false, true}) {
        std::string kind = rational ? " rational" : "";
        add("bezier" + kind, patch({}, true, 4, 7, rational));
        add("bspline" + kind, patch(bSpline, true, 5, 5, rational));
        add("catmullrom" + kind, patch(catmullRom, true, 5, 4, rational));
        add("bilinear" + kind, patch({}, false, 3, 4, rational));
    }
    NuPatchRecord nurbs{{5, 3, {0, 0, 0, 1, 3, 4, 4, 4}, 0.5f, 4},
                        {4, 4, {0, 1, 2, 3, 4, 5, 6, 7}, 3, 4}};
    add("nurbs", surfaceOf(nurbs, {parameter("P", StorageClass::Vertex, ValueType::Point,
                                             bumpySheet(5, 4, false))}));
    add("nurbs rational", surfaceOf(nurbs, {parameter("Pw", StorageClass::Vertex, ValueType::HPoint,
                                                      bumpySheet(5, 4, true))}));
    nurbs.u = {6, 6, {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}, 0, 1};
    add("nurbs of high order",
        surfaceOf(nurbs, {parameter("Pw", StorageClass::Vertex, ValueType::HPoint,
                                    bumpySheet(6, 4, true))}));
    PatchMeshRecord one;
    one.uVertices = one.vVertices = 2;
    add("patch with N",
        surfaceOf(one, {parameter("P", StorageClass::Vertex, ValueType::Point,
                                  {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0.5f}),
                        normals}),
        true);
    PolygonsRecord square{{1}, {4}, {0, 1, 2, 3}};
    auto corners = parameter("P", StorageClass::Vertex, ValueType::Point,
                             {0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 1, 0});
    add("polygon", surfaceOf(square, {corners}));
    add("polygon with N", surfaceOf(square, {corners, normals}), true);
    for (const Stroke &stroke : strokes()) {
        Attributes attributes;
        attributes.vBasis = stroke.isSpline ? bSpline : BasisRecord{};
        add(stroke.name, surfaceOf(stroke.shape, stroke.variables, attributes), stroke.hasNormals);
    }
    return cases;
}

const std::vector<Case> &cases() {
    static const std::vector<Case> all = allCases();
    return all;
}

const DiceRate rates[] = {{1e9f, 1e9f},  {1e9f, 0.1f},   {0.3f, 1e9f},  {1e9f, 1e-3f},
                          {0.02f, 0.1f}, {0.05f, 1e-4f}, {1e-9f, 1e-3f}};

TEST(Protocol, TrianglesAreCountedExactly) {
    for (const Case &c : cases())
        for (const DiceRate &rate : rates)
            EXPECT_EQ(c.surface->triangleCount(rate),
                      double(c.surface->dice(rate).triangles.size()))
                << c.name << " " << rate.edgeLength << " " << rate.chordError;
}

/// The sides where a patch is a point, in all combinations.
TEST(Protocol, TrianglesOfCollapsedSidesAreCounted) {
    for (int which = 1; which < 15; ++which) {
        std::vector<float> p;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                float x = float(i), y = float(j), z = 0.3f * float(i * j);
                if ((which & 1 && j == 0) || (which & 2 && j == 3))
                    x = 1.5f, z = 0;
                if ((which & 4 && i == 0) || (which & 8 && i == 3))
                    y = 1.5f, z = 0;
                p.insert(p.end(), {x, y, z});
            }
        PatchMeshRecord mesh;
        mesh.bicubic = true, mesh.uVertices = mesh.vVertices = 4;
        auto surface = surfaceOf(mesh, {parameter("P", StorageClass::Vertex, ValueType::Point, p)});
        for (const DiceRate &rate : rates) {
            DicedMesh diced = surface->dice(rate);
            EXPECT_EQ(surface->triangleCount(rate), double(diced.triangles.size())) << which;
            EXPECT_GT(diced.triangles.size(), 0u) << which;
        }
    }
}

/// A unit normal and how it changes.
struct Turning {
    Vec3 N, du, dv;
};

struct Shading {
    Vec3 P, N, dNdu, dNdv, Ng, dNgdu, dNgdv;
    float u = 0, v = 0, areaScale = 0;
};

Shading shadingAt(const Surface &surface, float u, float v, std::uint32_t piece = 0) {
    Shading s;
    SurfaceAnswer answer;
    auto planes = [](Vec3 &to) { return Vec3Planes{&to.x, &to.y, &to.z}; };
    answer.P = planes(s.P), answer.N = planes(s.N);
    answer.dNdu = planes(s.dNdu), answer.dNdv = planes(s.dNdv);
    answer.Ng = planes(s.Ng);
    answer.dNgdu = planes(s.dNgdu), answer.dNgdv = planes(s.dNgdv);
    answer.u = &s.u, answer.v = &s.v, answer.areaScale = &s.areaScale;
    surface.evaluate({1, &piece, &u, &v}, answer);
    s.N = normalize(s.N), s.Ng = normalize(s.Ng);
    return s;
}
std::array<Turning, 2> normalsOf(const Shading &s) {
    return {Turning{s.N, s.dNdu, s.dNdv}, Turning{s.Ng, s.dNgdu, s.dNgdv}};
}

/// Central differences as for P in quadrics_test; unit normals here have derivatives below 30.
TEST(Protocol, NormalsTurnAsTheirDerivativesSay) {
    const float h = 2e-3f;
    for (const Case &c : cases()) {
        bool polygon = c.surface->dice({}).vertexUv.empty();
        for (float u : {0.11f, 0.37f, 0.59f})
            for (float v : {0.13f, 0.29f, 0.71f}) {
                if (polygon && u + v > 0.9f)
                    continue;
                Shading s = shadingAt(*c.surface, u, v);
                Shading left = shadingAt(*c.surface, u - h, v),
                        right = shadingAt(*c.surface, u + h, v);
                Shading below = shadingAt(*c.surface, u, v - h),
                        above = shadingAt(*c.surface, u, v + h);
                // The query's coordinates need not be those of shaders: the chain rule.
                for (int which : {0, 1}) {
                    auto unit = [which](const Shading &at) { return normalsOf(at)[which].N; };
                    const auto [N, dNdu, dNdv] = normalsOf(s)[which];
                    Vec3 byA = dNdu * (right.u - left.u) + dNdv * (right.v - left.v);
                    Vec3 byB = dNdu * (above.u - below.u) + dNdv * (above.v - below.v);
                    double scale = 2 * h * (1 + length(dNdu) + length(dNdv));
                    EXPECT_LT(length(byA - (unit(right) - unit(left))), 5e-3 * scale) << c.name;
                    EXPECT_LT(length(byB - (unit(above) - unit(below))), 5e-3 * scale) << c.name;
                    EXPECT_NEAR(dot(dNdu, N), 0, 1e-4 * scale / h) << c.name;
                    EXPECT_NEAR(dot(dNdv, N), 0, 1e-4 * scale / h) << c.name;
                }
            }
    }
}

TEST(Protocol, NormalDerivativesAreFiniteEverywhere) {
    for (const Case &c : cases())
        for (float u : {0.0f, 0.3f, 1.0f})
            for (float v : {0.0f, 1e-7f, 0.5f, 1 - 6e-8f, 1.0f}) {
                Shading s = shadingAt(*c.surface, u, v);
                EXPECT_TRUE(isFinite(s.dNdu) && isFinite(s.dNdv)) << c.name << " " << u << " " << v;
                EXPECT_TRUE(s.areaScale >= 0 && std::isfinite(s.areaScale)) << c.name;
            }
}

/// Composite Gauss quadrature, 2 points a cell: errs by the fourth power of the cells' size.
double integralOfAreaScale(const Surface &surface, int cells) {
    double sum = 0;
    auto node = [&](int i) {
        double within = 0.5 + (i % 2 ? 1 : -1) * 0.5 / std::sqrt(3.0);
        return float((i / 2 + within) / cells);
    };
    for (std::uint32_t piece = 0; piece < surface.domain().pieces; ++piece)
        for (int i = 0; i < 2 * cells; ++i)
            for (int j = 0; j < 2 * cells; ++j)
                sum += shadingAt(surface, node(i), node(j), piece).areaScale;
    return sum / (4.0 * cells * cells);
}

TEST(Protocol, AreaScalesAddUpToTheArea) {
    for (const Case &c : cases()) {
        if (c.surface->dice({}).vertexUv.empty())
            continue;
        EXPECT_NEAR(integralOfAreaScale(*c.surface, 48) / c.surface->area(), 1, 1e-4) << c.name;
    }
}

TEST(Protocol, AreaScaleOfATriangleIsTwiceItsArea) {
    auto surface = surfaceOf(
        PolygonsRecord{{1}, {3}, {0, 1, 2}},
        {parameter("P", StorageClass::Vertex, ValueType::Point, {0, 0, 0, 3, 0, 0, 0, 0, 4})});
    EXPECT_FLOAT_EQ(shadingAt(*surface, 0.2f, 0.3f).areaScale, 12);
    Shading s = shadingAt(*surface, 0.2f, 0.3f);
    EXPECT_EQ(s.dNdu, Vec3());
    EXPECT_EQ(s.dNdv, Vec3());
}

TEST(Protocol, WholeSpheresAndStrokesAreRound) {
    for (const Case &c : cases()) {
        const bool whole = c.name == "sphere" || c.name == "sphere inside out";
        const bool stroke = c.name.starts_with("tube") || c.name.starts_with("points");
        EXPECT_EQ(c.surface->isRound(), whole || stroke) << c.name;
        EXPECT_EQ(c.surface->isStroke(), stroke) << c.name;
        if (whole) {
            ASSERT_TRUE(c.surface->roundElements().isOneBall()) << c.name;
            EXPECT_EQ(c.surface->roundElements().knots[0][3], 1.5f) << c.name;
        }
    }
    EXPECT_EQ(surfaceOf(SphereRecord{2, -9, 9, -360})->roundElements().knots[0][3], 2.0f);
}

/// Points near round elements get the names of the nearest ones on the surface.
TEST(Protocol, PlacesOnStrokesComeBack) {
    for (const Case &c : cases()) {
        if (!c.surface->isStroke())
            continue;
        const RoundElements round = c.surface->roundElements();
        const std::uint32_t pieces = c.surface->domain().pieces;
        const auto splits = std::uint32_t(round.size() / pieces);
        for (std::uint32_t number = 0; number < pieces; ++number)
            for (float u : {0.05f, 0.3f, 0.8f})
                for (float v : {0.02f, 0.4f, 0.93f}) {
                    const Vec3 p = at(*c.surface, u, v, number).P;
                    const float place = v * float(splits);
                    std::uint32_t piece = number * splits + std::uint32_t(place);
                    float foundU = place - std::floor(place), foundV = -1;
                    c.surface->nameRound(1,
                                         {const_cast<float *>(&p.x), const_cast<float *>(&p.y),
                                          const_cast<float *>(&p.z)},
                                         nullptr, &piece, &foundU, &foundV);
                    EXPECT_EQ(piece, number) << c.name;
                    EXPECT_LT(length(at(*c.surface, foundU, foundV, piece).P - p), 1e-5f)
                        << c.name << " " << number << " " << u << " " << v;
                }
    }
}

/// Rays meet round elements where the surface is: of tubes, circles across their knots' cubic.
TEST(Protocol, RoundElementsLieOnTheirSurfaces) {
    for (const Case &c : cases()) {
        const RoundElements round = c.surface->roundElements();
        for (std::size_t i = 0; c.surface->isStroke() && i < round.tubes.size(); ++i) {
            const auto splits = round.size() / c.surface->domain().pieces;
            for (float along : {0.0f, 0.4f, 1.0f}) {
                float centre[4];
                for (int k = 0; k < 4; ++k) {
                    const auto *knot = &round.knots[round.tubes[i]];
                    const float w = 1 - along;
                    centre[k] = w * w * w * knot[0][k] + 3 * w * w * along * knot[1][k] +
                                3 * w * along * along * knot[2][k] +
                                along * along * along * knot[3][k];
                }
                const float v = (float(i % splits) + along) / float(splits);
                for (float u : {0.1f, 0.6f}) {
                    const Vec3 p = at(*c.surface, u, v, std::uint32_t(i / splits)).P;
                    const Vec3 way = p - Vec3{centre[0], centre[1], centre[2]};
                    EXPECT_NEAR(length(way), centre[3], 1e-5f) << c.name << " " << i;
                }
            }
        }
    }
}

TEST(Protocol, PlacesOnSpheresComeBack) {
    for (float radius : {1.5f, -1.5f, 1e-9f, 1e9f})
        for (float theta : {360.0f, -360.0f}) {
            auto surface =
                surfaceOf(SphereRecord{radius, -std::abs(radius), std::abs(radius), theta});
            float r = surface->roundElements().knots[0][3];
            std::mt19937 random(3);
            std::normal_distribution<float> normal;
            std::vector<Vec3> places{{0, 0, 1},  {0, 0, -1}, {1, 0, 0},       {-1, 0, 0},
                                     {0, -1, 0}, {0, 1, 0},  {-1, -1e-9f, 0}, {1, -1e-9f, 0}};
            for (float tiny : {1e-3f, 1e-5f, 1e-7f})
                places.push_back(normalize(Vec3{tiny, -tiny, 1}));
            while (places.size() < 400)
                places.push_back(normalize(Vec3{normal(random), normal(random), normal(random)}));
            for (Vec3 place : places) {
                Vec3 p = place * r;
                float u = -1, v = -1;
                std::uint32_t piece = 0;
                surface->nameRound(1, {&p.x, &p.y, &p.z}, nullptr, &piece, &u, &v);
                EXPECT_TRUE(u >= 0 && u <= 1 && v >= 0 && v <= 1);
                // u and v are floats of turns: 2 pi 2^-24, twice.
                EXPECT_LT(length(at(*surface, u, v).P - p), 1e-6f * r) << place.x << " " << place.z;
            }
        }
}

TEST(Protocol, UnderAPixelAHandfulOfTrianglesIsEnough) {
    for (const Case &c : cases()) {
        DicedMesh mesh = c.surface->dice({1e9f, 1e9f});
        EXPECT_LE(mesh.triangles.size(), 72u) << c.name;
        EXPECT_GT(areaOf(mesh), 0.5 * c.surface->area()) << c.name;
        EXPECT_LE(sampledChordError(*c.surface, mesh, 40), mesh.chordError) << c.name;
    }
    auto sphere = surfaceOf(SphereRecord{1, -1, 1, 360});
    DicedMesh mesh = sphere->dice({100, 100});
    EXPECT_LE(mesh.triangles.size(), 24u);
    EXPECT_EQ(borderEdges(mesh), 0);
}

} // namespace
} // namespace candela
