// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/test_support.h"

namespace candela {
namespace {

using namespace geometrytest;

struct Case {
    const char *name;
    ShapeRecord shape;
    /// Zero on the surface, and with about unit gradient, for lengths of about 1.
    double (*implicit)(double x, double y, double z);
};

double sphereAt(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z) - 1.5; }
double coneAt(double x, double y, double z) { return std::hypot(x, y) - 0.5 * (1 - z / 2); }
double cylinderAt(double x, double y, double) { return std::hypot(x, y) - 0.7; }
double paraboloidAt(double x, double y, double z) { return z - 1.2 * (x * x + y * y) / 0.64; }
double diskAt(double, double, double z) { return z + 0.3; }
double torusAt(double x, double y, double z) { return std::hypot(std::hypot(x, y) - 2, z) - 0.6; }
double spindleAt(double x, double y, double z) {
    double r = std::hypot(x, y);
    return std::min(std::abs(std::hypot(r - 0.3, z) - 1), std::abs(std::hypot(r + 0.3, z) - 1));
}
/// The line through (1,-.5,-1) and (.6,.9,1.4), turned: r^2 is a parabola in z.
double hyperboloidAt(double x, double y, double z) {
    double v = (z + 1) / 2.4, px = 1 - 0.4 * v, py = -0.5 + 1.4 * v;
    return std::hypot(x, y) - std::hypot(px, py);
}

const Case cases[] = {
    {"sphere", SphereRecord{1.5f, -1.5f, 1.5f, 360}, sphereAt},
    {"sphere part", SphereRecord{1.5f, -0.4f, 1.1f, 200}, sphereAt},
    {"sphere backwards", SphereRecord{1.5f, -1.5f, 1.5f, -130}, sphereAt},
    {"sphere inside out", SphereRecord{-1.5f, -1.5f, 1.5f, 360}, sphereAt},
    {"cone", ConeRecord{2, 0.5f, 360}, coneAt},
    {"cone part", ConeRecord{2, 0.5f, 75}, coneAt},
    {"cylinder", CylinderRecord{0.7f, -1, 2, 360}, cylinderAt},
    {"cylinder part", CylinderRecord{0.7f, 2, -1, 95}, cylinderAt},
    {"hyperboloid", HyperboloidRecord{{1, -0.5f, -1}, {0.6f, 0.9f, 1.4f}, 360}, hyperboloidAt},
    {"hyperboloid part", HyperboloidRecord{{1, -0.5f, -1}, {0.6f, 0.9f, 1.4f}, 140}, hyperboloidAt},
    {"paraboloid", ParaboloidRecord{0.8f, 0, 1.2f, 360}, paraboloidAt},
    {"paraboloid part", ParaboloidRecord{0.8f, 0.3f, 1.2f, 210}, paraboloidAt},
    {"disk", DiskRecord{-0.3f, 1.1f, 360}, diskAt},
    {"disk part", DiskRecord{-0.3f, 1.1f, 50}, diskAt},
    {"torus", TorusRecord{2, 0.6f, 0, 360, 360}, torusAt},
    {"torus part", TorusRecord{2, 0.6f, 30, 250, 100}, torusAt},
    {"spindle torus", TorusRecord{0.3f, 1, 0, 360, 360}, spindleAt},
};

const float someU[] = {0, 0.0625f, 0.3f, 0.5f, 0.71f, 1};

class Quadrics : public testing::TestWithParam<Case> {
protected:
    std::shared_ptr<const Surface> surface_ = surfaceOf(GetParam().shape);
};

TEST_P(Quadrics, LieOnTheirImplicitEquation) {
    for (float u : someU)
        for (float v : someU) {
            Vec3 p = at(*surface_, u, v).P;
            EXPECT_NEAR(GetParam().implicit(p.x, p.y, p.z), 0, 3e-6) << u << " " << v;
        }
}

/// Central differences of step h err by h^2/6 of the third derivative (here below 300) and by
/// rounding, 2e-6/h of the extent: 3e-3 in all for h = 2e-3 relative to the derivatives' size.
TEST_P(Quadrics, DerivativesAreThoseOfP) {
    const float h = 2e-3f;
    for (float u : {0.1f, 0.35f, 0.8f})
        for (float t : {0.15f, 0.4f, 0.85f}) {
            Point p = at(*surface_, u, t);
            Point left = at(*surface_, u - h, t), right = at(*surface_, u + h, t);
            Vec3 du = (right.P - left.P) / (right.u - left.u);
            EXPECT_LT(length(p.dPdu - du), 5e-3f * (1 + length(du)));
            Point below = at(*surface_, u, t - h), above = at(*surface_, u, t + h);
            Vec3 dv = (above.P - below.P) / (above.v - below.v);
            EXPECT_LT(length(p.dPdv - dv), 5e-3f * (1 + length(dv)));
            Vec3 normal = cross(p.dPdu, p.dPdv);
            EXPECT_LT(length(p.Ng - normal), 1e-5f * length(normal));
        }
}

TEST_P(Quadrics, NormalsAreGoodEverywhere) {
    for (float u : someU)
        for (float v : {0.0f, 1e-7f, 1e-4f, 0.5f, 1 - 1e-4f, 1 - 6e-8f, 1.0f}) {
            Point p = at(*surface_, u, v);
            for (Vec3 x : {p.P, p.Ng, p.N, p.dPdu, p.dPdv})
                EXPECT_TRUE(isFinite(x));
            EXPECT_GT(length(p.Ng), 0);
            EXPECT_GT(length(p.dPdu), 0);
            EXPECT_GT(length(p.dPdv), 0);
            EXPECT_EQ(p.N, p.Ng);
        }
}

TEST_P(Quadrics, AreaIsThatOfFineDicing) {
    DicedMesh mesh = surface_->dice({1e9f, 2e-4f});
    EXPECT_NEAR(areaOf(mesh) / surface_->area(), 1, 2e-3);
}

TEST_P(Quadrics, BoundIsTight) {
    Box3 bound = surface_->bound(), seen;
    DicedMesh mesh = surface_->dice({0.01f, 1});
    for (Vec3 p : mesh.positions)
        seen.add(p);
    float scale = length(bound.extent());
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(bound.low[axis], seen.low[axis] + mesh.chordError);
        EXPECT_GE(bound.high[axis], seen.high[axis] - mesh.chordError);
        EXPECT_NEAR(bound.low[axis], seen.low[axis], 1e-4f * scale);
        EXPECT_NEAR(bound.high[axis], seen.high[axis], 1e-4f * scale);
    }
}

TEST_P(Quadrics, ChordErrorIsCertified) {
    for (float wanted : {0.1f, 0.01f, 0.001f}) {
        DicedMesh mesh = surface_->dice({1e9f, wanted});
        EXPECT_LE(mesh.chordError, wanted + 1e-5f);
        EXPECT_LE(sampledChordError(*surface_, mesh), mesh.chordError);
    }
}

TEST_P(Quadrics, EdgesAreNoLongerThanAsked) {
    DicedMesh mesh = surface_->dice({0.2f, 1e9f});
    for (const auto &t : mesh.triangles)
        for (int k = 0; k < 3; ++k)
            EXPECT_LE(length(mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]), 0.2f);
}

TEST_P(Quadrics, TrianglesTurnWithTheNormal) {
    DicedMesh mesh = surface_->dice({1e9f, 0.02f});
    for (const auto &t : mesh.triangles) {
        Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
        float u = (mesh.vertexUv[t[0]][0] + mesh.vertexUv[t[1]][0] + mesh.vertexUv[t[2]][0]) / 3;
        float v = (mesh.vertexUv[t[0]][1] + mesh.vertexUv[t[1]][1] + mesh.vertexUv[t[2]][1]) / 3;
        if (std::string(GetParam().name) != "spindle torus") { // It turns over on the axis.
            EXPECT_GT(dot(cross(b - a, c - a), at(*surface_, u, v).Ng), 0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Quadrics, testing::ValuesIn(cases), [](const auto &info) {
    std::string name = info.param.name;
    std::ranges::replace(name, ' ', '_');
    return name;
});

TEST(QuadricsAsWholes, AreCappedAtAbsurdRates) {
    for (ShapeRecord shape :
         {ShapeRecord(SphereRecord{1, -1, 1, 360}), ShapeRecord(CylinderRecord{1, -1, 1, 360})})
        for (DiceRate rate : {DiceRate{1e-9f, NAN}, DiceRate{INFINITY, NAN}}) {
            std::size_t triangles = surfaceOf(shape)->dice(rate).triangles.size();
            EXPECT_LE(triangles, 2.2e6);
            EXPECT_GE(triangles, 1e6);
        }
}

TEST(QuadricsAsWholes, AreWatertight) {
    auto borders = [](ShapeRecord shape) {
        return borderEdges(surfaceOf(shape)->dice({0.2f, 0.01f}));
    };
    EXPECT_EQ(borders(SphereRecord{1.5f, -1.5f, 1.5f, 360}), 0);
    EXPECT_EQ(borders(SphereRecord{1e-3f, -1, 1, 360}), 0);
    EXPECT_EQ(borders(TorusRecord{2, 0.6f, 0, 360, 360}), 0);
    EXPECT_EQ(borders(TorusRecord{2, 0.6f, -75, 285, 360}), 0);
    EXPECT_GT(borders(ConeRecord{2, 0.5f, 360}), 0);
    EXPECT_GT(borders(SphereRecord{1.5f, -1.5f, 1.5f, 300}), 0);
}

TEST(QuadricsAsWholes, HaveTheirClosedAreas) {
    const double pi = std::numbers::pi;
    auto area = [](ShapeRecord shape) { return surfaceOf(shape)->area(); };
    EXPECT_NEAR(area(SphereRecord{2, -2, 2, 360}), 16 * pi, 1e-4);
    EXPECT_NEAR(area(SphereRecord{2, 0, 1, 180}), 2 * pi, 1e-5); // Archimedes.
    EXPECT_NEAR(area(ConeRecord{4, 3, 360}), pi * 3 * 5, 1e-4);
    EXPECT_NEAR(area(CylinderRecord{2, -1, 2, 90}), 3 * pi, 1e-5);
    EXPECT_NEAR(area(DiskRecord{5, 2, 360}), 4 * pi, 1e-5);
    EXPECT_NEAR(area(TorusRecord{3, 1, 0, 360, 360}), 4 * pi * pi * 3, 1e-4);
    EXPECT_NEAR(area(HyperboloidRecord{{1, 0, 0}, {3, 0, 0}, 360}), 8 * pi, 1e-4);
    EXPECT_NEAR(area(HyperboloidRecord{{1, -1, 0}, {1, 1, 0}, 360}), 2 * pi, 1e-5);
    EXPECT_NEAR(area(ParaboloidRecord{1, 0, 1, 360}), pi / 6 * (std::pow(5, 1.5) - 1), 1e-5);
}

/// Lamps shine from their triangles: flat ones have the true area however coarse they are. The last
/// cell of a part of a turn may be narrower than the others.
TEST(QuadricsAsWholes, DisksAndRingsKeepTheirAreaWhenDiced) {
    for (float chord : {1.0f, 0.1f, 0.01f, 1e-3f, 1e-4f})
        for (float sweep : {360.0f, 180.0f, 100.0f, -30.0f}) {
            auto disk = surfaceOf(DiskRecord{1, 1.5f, sweep});
            auto ring = surfaceOf(HyperboloidRecord{{0.5f, 0, 1}, {1.5f, 0, 1}, sweep});
            for (const auto &surface : {disk, ring}) {
                DicedMesh mesh = surface->dice({100, chord});
                double ratio = areaOf(mesh) / surface->area();
                double cell = std::min(1.0, std::sqrt(8 * double(mesh.chordError) / 1.5));
                bool whole = std::abs(sweep) >= 180;
                double slack = whole ? 0 : cell * cell * cell / 6 / (std::abs(sweep) / 57.3);
                EXPECT_GT(ratio, 1 - 2e-6) << chord << " " << sweep;
                EXPECT_LT(ratio, 1 + 2e-6 + slack) << chord << " " << sweep;
            }
        }
}

TEST(QuadricsAsWholes, FaceOutwards) {
    auto outwards = [](ShapeRecord shape, Vec3 from) {
        auto surface = surfaceOf(shape);
        for (float u : someU)
            for (float v : someU) {
                Point p = at(*surface, u, v);
                EXPECT_GT(dot(p.Ng, p.P - from), 0) << u << " " << v;
            }
    };
    outwards(SphereRecord{1, -1, 1, 360}, {});
    outwards(ConeRecord{1, 1, 360}, {0, 0, -1});
    outwards(CylinderRecord{1, -1, 1, 360}, {});
    outwards(DiskRecord{1, 1, 360}, {}); // RI 3.2: along +z.
}

TEST(QuadricsAsWholes, FollowRiParameters) {
    auto sphere = surfaceOf(SphereRecord{2, -1, 2, 180});
    EXPECT_NEAR(at(*sphere, 0, 0).P.z, -1, 1e-6);
    EXPECT_NEAR(at(*sphere, 0.5f, 0).P.y, std::sqrt(3), 1e-6);
    auto torus = surfaceOf(TorusRecord{2, 1, 0, 90, 90});
    EXPECT_LT(length(at(*torus, 0, 0).P - Vec3{3, 0, 0}), 1e-6f);
    EXPECT_LT(length(at(*torus, 1, 1).P - Vec3{0, 2, 1}), 1e-6f);
    auto disk = surfaceOf(DiskRecord{1, 2, 360});
    EXPECT_LT(length(at(*disk, 0, 0).P - Vec3{2, 0, 1}), 1e-6f);
    auto cone = surfaceOf(ConeRecord{3, 2, 360});
    EXPECT_LT(length(at(*cone, 0, 1).P - Vec3{0, 0, 3}), 1e-6f);
    auto hyperboloid = surfaceOf(HyperboloidRecord{{1, 2, 3}, {4, 5, 6}, 90});
    EXPECT_LT(length(at(*hyperboloid, 0, 1).P - Vec3{4, 5, 6}), 1e-6f);
    EXPECT_LT(length(at(*hyperboloid, 1, 0).P - Vec3{-2, 1, 3}), 1e-6f);
    // z = zmin + v (zmax - zmin), whatever the dicing parameter.
    auto paraboloid = surfaceOf(ParaboloidRecord{2, 1, 4, 360});
    for (float t : someU) {
        Point p = at(*paraboloid, 0.2f, t);
        EXPECT_NEAR(p.P.z, 1 + 3 * p.v, 1e-5);
    }
}

TEST(QuadricsAsWholes, NormalsAtPolesAreTheLimits) {
    auto along = [](const Surface &surface, float u, float v, Vec3 expected) {
        EXPECT_LT(length(normalize(at(surface, u, v).Ng) - expected), 1e-5f);
    };
    auto sphere = surfaceOf(SphereRecord{1, -1, 1, 360});
    along(*sphere, 0.3f, 1, {0, 0, 1});
    along(*sphere, 0.3f, 0, {0, 0, -1});
    along(*surfaceOf(ParaboloidRecord{1, 0, 1, 360}), 0.6f, 0, {0, 0, -1});
    along(*surfaceOf(DiskRecord{1, 1, 360}), 0.6f, 1, {0, 0, 1});
    float r = std::sqrt(0.5f);
    along(*surfaceOf(ConeRecord{1, 1, 360}), 0, 1, {r, 0, r});
    along(*surfaceOf(ConeRecord{1, 1, 360}), 0.25f, 1, {0, r, r});
}

TEST(QuadricsAsWholes, CarryVariables) {
    Attributes attributes;
    attributes.textureCoordinates = {0, 0, 2, 0, 0, 3, 2, 3};
    auto surface = surfaceOf(ParaboloidRecord{2, 1, 4, 360},
                             {parameter("Cs", StorageClass::Varying, ValueType::Color,
                                        {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 5}),
                              parameter("heat", StorageClass::Constant, ValueType::Float, {7}),
                              parameter("pair", StorageClass::Uniform, ValueType::Float, {3, 4}, 2),
                              parameter("label", StorageClass::Uniform, ValueType::String, {}),
                              parameter("N", StorageClass::Vertex, ValueType::Normal,
                                        {0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0})},
                             attributes);
    EXPECT_EQ(surface->variables().size(), 5u);
    Point p = at(*surface, 0.25f, 0.6f);
    Value color = variable(*surface, "Cs", 0.25f, 0.6f);
    EXPECT_FLOAT_EQ(color.value[0], p.u);
    EXPECT_FLOAT_EQ(color.value[1], p.v);
    EXPECT_FLOAT_EQ(color.value[2], 5 * p.u * p.v);
    EXPECT_FLOAT_EQ(color.du[2], 5 * p.v);
    EXPECT_FLOAT_EQ(color.dv[2], 5 * p.u);
    EXPECT_EQ(variable(*surface, "heat", 0.1f, 0.2f).value[0], 7);
    EXPECT_EQ(variable(*surface, "pair", 0.1f, 0.2f).value[1], 4);
    EXPECT_FLOAT_EQ(variable(*surface, "s", 0.25f, 0.6f).value[0], 0.5f);
    EXPECT_FLOAT_EQ(variable(*surface, "t", 0.25f, 0.6f).value[0], 3 * p.v);
    EXPECT_FLOAT_EQ(variable(*surface, "t", 0.25f, 0.6f).dv[0], 3);
    EXPECT_LT(length(p.N - Vec3{0, p.v, 1 - p.v}), 1e-6f);
}

TEST(QuadricsAsWholes, SplitSt) {
    auto surface = surfaceOf(SphereRecord{1, -1, 1, 360},
                             {parameter("st", StorageClass::Varying, ValueType::Float,
                                        {0, 10, 1, 10, 0, 11, 1, 11}, 2)});
    EXPECT_FLOAT_EQ(variable(*surface, "s", 0.25f, 0.5f).value[0], 0.25f);
    EXPECT_FLOAT_EQ(variable(*surface, "t", 0.25f, 0.5f).value[0], 10.5f);
    EXPECT_EQ(surface->variables().size(), 2u);
}

TEST(BadQuadrics, AreReportedAndDropped) {
    const float inf = INFINITY;
    const ShapeRecord bad[] = {
        SphereRecord{0, -1, 1, 360},
        SphereRecord{1, 0.5f, 0.5f, 360},
        SphereRecord{1, -1, 1, 0},
        SphereRecord{NAN, -1, 1, 360},
        SphereRecord{1, -1, 1, inf},
        SphereRecord{1e30f, -1e30f, 1e30f, 360},
        ConeRecord{1, 0, 360},
        ConeRecord{NAN, 1, 360},
        CylinderRecord{1, 2, 2, 360},
        DiskRecord{1, 0, 360},
        DiskRecord{0, 1, 0},
        HyperboloidRecord{{1, 2, 3}, {1, 2, 3}, 360},
        TorusRecord{1, 0, 0, 360, 360},
        HyperboloidRecord{{0, 0, 3}, {0, 0, 1}, 360},
        TorusRecord{1, 1, 0, 900, 360},
        TorusRecord{1, 1, inf, 0, 360},
        ParaboloidRecord{1, 0, 0, 360},
        ParaboloidRecord{1, -1, 1, 360},
        ParaboloidRecord{0, 0, 1, 360},
        ParaboloidRecord{1, 1, 1, 360},
    };
    for (const ShapeRecord &shape : bad) {
        DiagnosticList diagnostics;
        EXPECT_TRUE(makeSurfaces(record(shape), {}, diagnostics).empty());
        EXPECT_EQ(diagnostics.count(Severity::Error), 1);
        EXPECT_EQ(diagnostics.text().substr(0, 12), "test.rib:17:");
    }
}

TEST(BadQuadrics, WrongVariablesAreReportedAndLeftOut) {
    DiagnosticList diagnostics;
    auto surfaces = makeSurfaces(
        record(SphereRecord{1, -1, 1, 360},
               {parameter("three", StorageClass::Varying, ValueType::Float, {1, 2, 3}),
                parameter("odd", StorageClass::Varying, ValueType::Color, {1, 2, 3, 4}),
                parameter("nan", StorageClass::Constant, ValueType::Float, {NAN})}),
        {}, diagnostics);
    ASSERT_EQ(surfaces.size(), 1u);
    EXPECT_EQ(surfaces[0]->variables().size(), 2u); // s and t
    EXPECT_EQ(diagnostics.count(Severity::Warning), 1);
    EXPECT_EQ(diagnostics.count(Severity::Error), 2);
}

TEST(BadQuadrics, VariablesWithAMeaningHaveItsSize) {
    for (auto [name, type, count] : {std::tuple{"Cs", ValueType::Matrix, 16},
                                     {"Os", ValueType::Float, 1},
                                     {"s", ValueType::Color, 3},
                                     {"st", ValueType::Float, 1},
                                     {"N", ValueType::Float, 1}}) {
        DiagnosticList diagnostics;
        auto surfaces = makeSurfaces(
            record(SphereRecord{1, -1, 1, 360},
                   {parameter(name, StorageClass::Constant, type, std::vector<float>(count, 1))}),
            {}, diagnostics);
        ASSERT_EQ(surfaces.size(), 1u);
        EXPECT_EQ(surfaces[0]->variables().size(), 2u) << name; // s and t
        EXPECT_EQ(diagnostics.count(Severity::Error), 1) << name;
    }
}

} // namespace
} // namespace candela
