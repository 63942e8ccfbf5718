// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/test_support.h"

#include <cmath>

namespace candela {
namespace {

using namespace geometrytest;

const BasisRecord bezier{};
const BasisRecord bSpline{{-1.f / 6, 3.f / 6, -3.f / 6, 1.f / 6, 3.f / 6, -6.f / 6, 3.f / 6, 0,
                           -3.f / 6, 0, 3.f / 6, 0, 1.f / 6, 4.f / 6, 1.f / 6, 0},
                          1};
const BasisRecord catmullRom{
    {-0.5f, 1.5f, -1.5f, 0.5f, 1, -2.5f, 2, -0.5f, -0.5f, 0, 0.5f, 0, 0, 1, 0, 0}, 1};
const BasisRecord hermite{{2, 1, -2, 1, -3, -2, 3, -1, 0, 1, 0, 0, 1, 0, 0, 0}, 2};
const BasisRecord power{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 4};

/// Independent evaluation of four ordinates by each basis' own definition.
using Curve = double (*)(const double *g, double t);

double deCasteljau(const double *g, double t) {
    double b[4] = {g[0], g[1], g[2], g[3]};
    for (int level = 3; level > 0; --level)
        for (int i = 0; i < level; ++i)
            b[i] = b[i] * (1 - t) + b[i + 1] * t;
    return b[0];
}

/// Uniform knots: the span [0,1] of knots -2..3.
double deBoor(const double *g, double t) {
    double d[4] = {g[0], g[1], g[2], g[3]};
    for (int level = 1; level <= 3; ++level)
        for (int i = 3; i >= level; --i) {
            double knot = i - 3, next = knot + 4 - level;
            double a = (t - knot) / (next - knot);
            d[i] = d[i - 1] * (1 - a) + d[i] * a;
        }
    return d[3];
}

/// Barry and Goldman's pyramid over knots -1, 0, 1, 2.
double pyramid(const double *g, double t) {
    auto mix = [t](double p, double q, double from, double to) {
        return ((to - t) * p + (t - from) * q) / (to - from);
    };
    double a = mix(g[0], g[1], -1, 0), b = mix(g[1], g[2], 0, 1), c = mix(g[2], g[3], 1, 2);
    return mix(mix(a, b, -1, 1), mix(b, c, 0, 2), 0, 1);
}

/// Point, tangent, point, tangent, through the equal Bezier curve.
double fromTangents(const double *g, double t) {
    double b[4] = {g[0], g[0] + g[1] / 3, g[2] - g[3] / 3, g[2]};
    return deCasteljau(b, t);
}

double fromPowers(const double *g, double t) { return ((g[0] * t + g[1]) * t + g[2]) * t + g[3]; }

struct BasisCase {
    const char *name;
    BasisRecord basis;
    Curve curve;
};
const BasisCase bases[] = {{"bezier", bezier, deCasteljau},
                           {"bspline", bSpline, deBoor},
                           {"catmullrom", catmullRom, pyramid},
                           {"hermite", hermite, fromTangents},
                           {"power", power, fromPowers}};

Attributes attributesOf(const BasisRecord &u, const BasisRecord &v) {
    Attributes attributes;
    attributes.uBasis = u;
    attributes.vBasis = v;
    return attributes;
}

/// Control points over a bumpy sheet: regular enough to have good normals.
std::vector<float> sheet(int nu, int nv, unsigned seed) {
    std::vector<float> noise = randomFloats(nu * nv * 3, seed), p;
    for (int j = 0; j < nv; ++j)
        for (int i = 0; i < nu; ++i)
            for (int c = 0; c < 3; ++c)
                p.push_back((c == 0   ? float(i)
                             : c == 1 ? float(j)
                                      : 0) +
                            0.25f * noise[(j * nu + i) * 3 + c]);
    return p;
}

Parameter points(std::vector<float> floats) {
    return parameter("P", StorageClass::Vertex, ValueType::Point, std::move(floats));
}

/// Component c of n of control net `values` at (u,v) of patch (column,row), by `curve` both ways.
double slowly(const std::vector<float> &values, int n, int c, int nu, int nv, int firstU,
              int firstV, Curve curveU, Curve curveV, double u, double v) {
    double rows[4];
    for (int j = 0; j < 4; ++j) {
        double g[4];
        for (int i = 0; i < 4; ++i)
            g[i] = values[(((firstV + j) % nv) * nu + (firstU + i) % nu) * n + c];
        rows[j] = curveU(g, u);
    }
    return curveV(rows, v);
}

class Bases : public testing::TestWithParam<std::tuple<int, int, bool, bool>> {};

TEST_P(Bases, AgreeWithTheirDefinitions) {
    auto [a, b, periodicU, periodicV] = GetParam();
    const BasisCase &u = bases[a], &v = bases[b];
    int patchesU = 3, patchesV = 2;
    // Periodic meshes have a multiple of the step, at least four.
    int nu = periodicU ? std::max(4, u.basis.step * 4) : 4 + (patchesU - 1) * u.basis.step;
    int nv = periodicV ? std::max(4, v.basis.step * 4) : 4 + (patchesV - 1) * v.basis.step;
    patchesU = periodicU ? nu / u.basis.step : patchesU;
    patchesV = periodicV ? nv / v.basis.step : patchesV;
    auto p = randomFloats(nu * nv * 3, 3), heat = randomFloats(nu * nv, 4);
    auto surface =
        surfaceOf(PatchMeshRecord{true, nu, nv, periodicU, periodicV},
                  {points(p), parameter("heat", StorageClass::Vertex, ValueType::Float, heat)},
                  attributesOf(u.basis, v.basis));
    for (int row = 0; row < patchesV; ++row)
        for (int column = 0; column < patchesU; ++column)
            for (double s : {0.1, 0.6})
                for (double t : {0.3, 0.9}) {
                    float meshU = float((column + s) / patchesU);
                    float meshV = float((row + t) / patchesV);
                    auto slow = [&](const std::vector<float> &values, int n, int c) {
                        return slowly(values, n, c, nu, nv, column * u.basis.step,
                                      row * v.basis.step, u.curve, v.curve, s, t);
                    };
                    Point q = at(*surface, meshU, meshV);
                    for (int c = 0; c < 3; ++c)
                        EXPECT_NEAR(q.P[c], slow(p, 3, c), 2e-5);
                    EXPECT_NEAR(variable(*surface, "heat", meshU, meshV).value[0], slow(heat, 1, 0),
                                2e-5);
                    EXPECT_EQ(q.u, meshU);
                    EXPECT_EQ(q.v, meshV);
                }
}

INSTANTIATE_TEST_SUITE_P(All, Bases,
                         testing::Combine(testing::Range(0, 5), testing::Range(0, 5),
                                          testing::Bool(), testing::Bool()));

/// Smooth surfaces of every kind, for what must hold of all of them.
struct Smooth {
    const char *name;
    std::shared_ptr<const Surface> surface;
    bool closedU = false;
};

std::vector<Smooth> smoothSurfaces() {
    std::vector<Smooth> all;
    all.push_back({"bezier", surfaceOf(PatchMeshRecord{true, 7, 10}, {points(sheet(7, 10, 1))})});
    all.push_back({"b-spline", surfaceOf(PatchMeshRecord{true, 6, 5}, {points(sheet(6, 5, 2))},
                                         attributesOf(bSpline, catmullRom))});
    all.push_back({"bilinear", surfaceOf(PatchMeshRecord{false, 4, 3}, {points(sheet(4, 3, 3))})});
    std::vector<float> p = sheet(4, 4, 4), w = randomFloats(16, 5), pw;
    for (int i = 0; i < 16; ++i)
        for (int c = 0; c < 4; ++c)
            pw.push_back((c < 3 ? p[3 * i + c] : 1) * (1 + 0.4f * w[i]));
    auto homogeneous = parameter("Pw", StorageClass::Vertex, ValueType::HPoint, pw);
    all.push_back({"rational", surfaceOf(PatchMeshRecord{true, 4, 4}, {homogeneous})});
    all.push_back({"rational bilinear", surfaceOf(PatchMeshRecord{false, 4, 4}, {homogeneous})});
    std::vector<float> tube;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 8; ++i) {
            double angle = 2 * std::numbers::pi * i / 8;
            tube.insert(tube.end(), {float(std::cos(angle)), float(std::sin(angle)), float(j)});
        }
    all.push_back({"tube",
                   surfaceOf(PatchMeshRecord{true, 8, 4, true, false}, {points(tube)},
                             attributesOf(bSpline, bSpline)),
                   true});
    all.push_back(
        {"prism", surfaceOf(PatchMeshRecord{false, 8, 4, true, false}, {points(tube)}), true});
    auto pz = parameter("Pz", StorageClass::Vertex, ValueType::Float, randomFloats(16, 6));
    all.push_back({"heights", surfaceOf(PatchMeshRecord{false, 4, 4}, {pz})});
    all.push_back({"cubic heights", surfaceOf(PatchMeshRecord{true, 4, 4}, {pz})});
    return all;
}

/// As for quadrics: h^2/6 times third derivatives (a few hundred) and rounding 1e-6/h.
TEST(Patches, DerivativesAreThoseOfP) {
    const float h = 1e-3f;
    for (const Smooth &smooth : smoothSurfaces())
        for (float u : {0.12f, 0.45f, 0.88f})
            for (float v : {0.1f, 0.42f, 0.9f}) {
                const Surface &surface = *smooth.surface;
                Point p = at(surface, u, v), left = at(surface, u - h, v);
                Point right = at(surface, u + h, v), below = at(surface, u, v - h);
                Point above = at(surface, u, v + h);
                Vec3 du = (right.P - left.P) / (right.u - left.u);
                Vec3 dv = (above.P - below.P) / (above.v - below.v);
                EXPECT_LT(length(p.dPdu - du), 4e-3f * (1 + length(du))) << smooth.name;
                EXPECT_LT(length(p.dPdv - dv), 4e-3f * (1 + length(dv))) << smooth.name;
                EXPECT_LT(length(p.Ng - cross(p.dPdu, p.dPdv)), 1e-5f * length(p.Ng));
            }
}

TEST(Patches, DiceWithinTheirCertificate) {
    for (const Smooth &smooth : smoothSurfaces())
        for (float wanted : {0.1f, 0.01f}) {
            DicedMesh mesh = smooth.surface->dice({1e9f, wanted});
            EXPECT_LE(mesh.chordError, wanted + 2e-4f) << smooth.name;
            EXPECT_LE(sampledChordError(*smooth.surface, mesh), mesh.chordError) << smooth.name;
        }
}

TEST(Patches, DiceWithinEdgeLengthAndCap) {
    for (const Smooth &smooth : smoothSurfaces()) {
        DicedMesh mesh = smooth.surface->dice({0.3f, 1e9f});
        for (const auto &t : mesh.triangles)
            for (int k = 0; k < 3; ++k)
                EXPECT_LE(length(mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]), 0.3001f);
    }
    auto mesh = smoothSurfaces()[0].surface->dice({1e-9f, NAN});
    EXPECT_LE(mesh.triangles.size(), 2.2e6);
}

TEST(Patches, DiceWithoutCracks) {
    for (const Smooth &smooth : smoothSurfaces()) {
        DicedMesh mesh = smooth.surface->dice({0.4f, 0.05f});
        // The border is the outside of one grid: u columns twice, v rows twice unless closed.
        int columns = 0;
        for (auto uv : mesh.vertexUv)
            columns += uv[1] == 0;
        int rows = int(mesh.vertexUv.size()) / columns - 1;
        int expected = 2 * (columns - 1) + (smooth.closedU ? 0 : 2 * rows);
        EXPECT_EQ(borderEdges(mesh), expected) << smooth.name;
    }
}

TEST(Patches, AreaIsThatOfFineDicing) {
    for (const Smooth &smooth : smoothSurfaces()) {
        DicedMesh mesh = smooth.surface->dice({0.05f, 1e-3f});
        EXPECT_NEAR(areaOf(mesh) / smooth.surface->area(), 1, 3e-3) << smooth.name;
    }
}

TEST(Patches, BoundsContainThem) {
    for (const Smooth &smooth : smoothSurfaces()) {
        Box3 bound = smooth.surface->bound();
        for (Vec3 p : smooth.surface->dice({0.1f, 1}).positions)
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(p[axis], bound.low[axis]) << smooth.name;
                EXPECT_LE(p[axis], bound.high[axis]) << smooth.name;
            }
    }
}

TEST(Patches, PeriodicMeshesCloseSmoothly) {
    auto all = smoothSurfaces();
    const Surface &tube = *all[5].surface;
    for (float v : {0.0f, 0.3f, 1.0f}) {
        Point start = at(tube, 0, v), end = at(tube, 1, v);
        EXPECT_LT(length(start.P - end.P), 2e-6f);
        EXPECT_LT(length(start.dPdu - end.dPdu), 2e-5f);
    }
}

TEST(Patches, BilinearNormalIsNatural) {
    // u along x, v along y: dPdu x dPdv along +z.
    auto surface = surfaceOf(PatchMeshRecord{}, {points({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})});
    EXPECT_EQ(at(*surface, 0.3f, 0.6f).Ng, (Vec3{0, 0, 1}));
    EXPECT_FLOAT_EQ(surface->area(), 1);
}

TEST(Patches, HeightsStandOverUAndV) {
    auto surface =
        surfaceOf(PatchMeshRecord{false, 3, 2},
                  {parameter("Pz", StorageClass::Vertex, ValueType::Float, {0, 1, 2, 0, 1, 4})});
    Point p = at(*surface, 0.75f, 0.5f);
    EXPECT_LT(length(p.P - Vec3{0.75f, 0.5f, 2}), 1e-6f);
    EXPECT_LT(length(p.dPdu - Vec3{1, 0, 4}), 1e-6f);
}

TEST(Patches, RationalQuarterCircleIsRound) {
    // Degree 2 raised to 3: the classic weights of a quarter circle, swept along z.
    double h = std::sqrt(0.5);
    double conic[3][3] = {{1, 0, 1}, {h, h, h}, {0, 1, 1}};
    std::vector<float> pw;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            double p[3];
            for (int c = 0; c < 3; ++c)
                p[c] = i == 0   ? conic[0][c]
                       : i == 1 ? (conic[0][c] + 2 * conic[1][c]) / 3
                       : i == 2 ? (2 * conic[1][c] + conic[2][c]) / 3
                                : conic[2][c];
            pw.insert(pw.end(), {float(p[0]), float(p[1]), float(p[2] * j), float(p[2])});
        }
    auto surface = surfaceOf(PatchMeshRecord{true, 4, 4},
                             {parameter("Pw", StorageClass::Vertex, ValueType::HPoint, pw)});
    for (float u : {0.0f, 0.2f, 0.5f, 0.9f, 1.0f}) {
        Point p = at(*surface, u, 0.4f);
        EXPECT_NEAR(std::hypot(p.P.x, p.P.y), 1, 1e-6);
        EXPECT_GT(dot(p.Ng, Vec3{p.P.x, p.P.y, 0}), 0.99f * length(p.Ng));
    }
    EXPECT_NEAR(surface->area(), 3 * std::numbers::pi / 2, 1e-4);
}

TEST(Patches, CollapsedEdgesHaveNormals) {
    // The top of a dome: all of v = 1 is the point (0,0,1).
    std::vector<float> p;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            float r[4] = {1, 1, 0.5f, 0}, z[4] = {0, 0.5f, 1, 1};
            float x[4] = {1, 1, 0.55f, 0}, y[4] = {0, 0.55f, 1, 1};
            p.insert(p.end(), {r[j] * x[i], r[j] * y[i], z[j]});
        }
    auto surface = surfaceOf(PatchMeshRecord{true, 4, 4}, {points(p)});
    for (float u : {0.0f, 0.4f, 1.0f})
        for (float v : {1.0f, 1 - 6e-8f, 1 - 1e-5f}) {
            Point top = at(*surface, u, v);
            EXPECT_GT(dot(normalize(top.Ng), Vec3{0, 0, 1}), 0.99f);
            EXPECT_TRUE(isFinite(top.dPdu) && isFinite(top.dPdv));
            EXPECT_NEAR(top.P.z, 1, 1e-4);
        }
    DicedMesh mesh = surface->dice({1e9f, 0.01f});
    EXPECT_LE(sampledChordError(*surface, mesh), mesh.chordError);
}

TEST(Patches, CarryVariablesOfEveryClass) {
    auto floats = [](std::string name, StorageClass storage, std::vector<float> values) {
        return parameter(std::move(name), storage, ValueType::Float, std::move(values));
    };
    // Two by one bicubic patches: six corners, two patches, twenty-eight control points.
    Attributes attributes;
    attributes.textureCoordinates = {0, 0, 4, 0, 0, 2, 4, 2};
    auto surface = surfaceOf(PatchMeshRecord{true, 7, 4},
                             {points(sheet(7, 4, 9)), floats("whole", StorageClass::Constant, {5}),
                              floats("patch", StorageClass::Uniform, {6, 7}),
                              floats("corner", StorageClass::Varying, {0, 1, 2, 10, 11, 12}),
                              floats("own", StorageClass::FaceVarying, {0, 1, 2, 3, 4, 5, 6, 7}),
                              parameter("Cs", StorageClass::Varying, ValueType::Color,
                                        {0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 1, 0, 0, 1, 1, 0, 1, 2}),
                              parameter("N", StorageClass::Varying, ValueType::Normal,
                                        {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 2, 1, 0, 2, 1, 0, 2, 1})},
                             attributes);
    auto get = [&](const char *name, float u, float v) {
        return variable(*surface, name, u, v).value[0];
    };
    EXPECT_EQ(get("whole", 0.3f, 0.2f), 5);
    EXPECT_EQ(get("patch", 0.3f, 0.2f), 6);
    EXPECT_EQ(get("patch", 0.7f, 0.2f), 7);
    EXPECT_FLOAT_EQ(get("corner", 0.75f, 0.5f), 6.5f);
    EXPECT_FLOAT_EQ(variable(*surface, "corner", 0.75f, 0.5f).du[0], 2);
    EXPECT_FLOAT_EQ(variable(*surface, "corner", 0.75f, 0.5f).dv[0], 10);
    EXPECT_FLOAT_EQ(get("own", 0.75f, 0.5f), 5.5f);
    EXPECT_FLOAT_EQ(variable(*surface, "Cs", 0.75f, 0.5f).value[2], 1.5f);
    EXPECT_FLOAT_EQ(variable(*surface, "Cs", 0.75f, 0.5f).value[1], 0.5f);
    EXPECT_FLOAT_EQ(get("s", 0.75f, 0.5f), 3);
    EXPECT_FLOAT_EQ(get("t", 0.75f, 0.5f), 1);
    EXPECT_FLOAT_EQ(variable(*surface, "s", 0.75f, 0.5f).du[0], 4);
    EXPECT_LT(length(at(*surface, 0.2f, 0.5f).N - Vec3{0, 1, 1}), 1e-6f);
}

TEST(Patches, ThatDoNotMeetAreDicedApart) {
    // A power basis joins nothing.
    auto surface = surfaceOf(PatchMeshRecord{true, 8, 4}, {points(sheet(8, 4, 8))},
                             attributesOf(power, power));
    DicedMesh mesh = surface->dice({1e9f, 0.1f});
    EXPECT_LE(sampledChordError(*surface, mesh), mesh.chordError);
}

TEST(BadPatches, AreReportedAndDropped) {
    auto refused = [](PatchMeshRecord mesh, std::vector<Parameter> variables,
                      const Attributes &attributes = {}) {
        DiagnosticList diagnostics;
        EXPECT_TRUE(
            makeSurfaces(record(mesh, std::move(variables)), attributes, diagnostics).empty());
        EXPECT_EQ(diagnostics.count(Severity::Error), 1);
        EXPECT_EQ(diagnostics.text().substr(0, 12), "test.rib:17:");
    };
    const std::vector<float> square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    std::vector<float> notFinite = square;
    notFinite[5] = INFINITY;
    refused({}, {});
    refused({}, {points(notFinite)});
    refused({false, 3, 2}, {points(square)});
    refused({false, 1, 4}, {points(square)});
    refused({false, -1, -4}, {points(square)});
    refused({true, 2, 2}, {points(square)});
    refused({true, 5, 4}, {points(sheet(5, 4, 1))}); // 5 does not fit steps of 3.
    refused({false, 100000, 100000}, {points(square)});
    refused({}, {points(std::vector<float>(12, 1.0f))});
    refused({}, {points({0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0})}); // A line.
    refused({}, {points({0, 0, 0, 1e30f, 0, 0, 0, 1, 0, 1, 1, 0})});
    refused({}, {parameter("Pz", StorageClass::Vertex, ValueType::Float, {0, 1, NAN, 1})});
    refused({}, {parameter("Pz", StorageClass::Vertex, ValueType::Float, {0, 1})});
    refused({}, {parameter("Pw", StorageClass::Vertex, ValueType::HPoint,
                           {0, 0, 0, 1, 1, 0, 0, -1, 0, 1, 0, 1, 1, 1, 0, 1})});
    Attributes stuck;
    stuck.uBasis.step = 0;
    refused({true, 4, 4}, {points(sheet(4, 4, 1))}, stuck);
    Attributes notANumber;
    notANumber.vBasis.matrix[3] = NAN;
    refused({true, 4, 4}, {points(sheet(4, 4, 1))}, notANumber);
}

TEST(Teapots, StandAndFaceOutwards) {
    DiagnosticList diagnostics;
    Attributes attributes;
    attributes.uBasis = attributes.vBasis = bSpline; // Has no part in it.
    const auto surfaces = makeSurfaces(
        record(GeometryRecord{"teapot"},
               {parameter("Cs", StorageClass::Constant, ValueType::Color, {0.1f, 0.2f, 0.3f})}),
        attributes, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    ASSERT_EQ(surfaces.size(), 32u);
    Box3 bound;
    for (const auto &surface : surfaces) {
        EXPECT_FLOAT_EQ(variable(*surface, "Cs", 0.3f, 0.3f).value[1], 0.2f);
        for (Vec3 p : surface->dice({1e9f, 1e-3f}).positions)
            bound.add(p);
    }
    EXPECT_NEAR(bound.low.z, 0, 1e-6);
    EXPECT_NEAR(bound.high.z, 3.15, 1e-6);
    EXPECT_NEAR(bound.low.x, -3, 1e-6);
    EXPECT_GT(bound.high.x, 3.4);
    EXPECT_NEAR(bound.high.y, 2, 2e-3); // Its circles are nearly round.
    EXPECT_NEAR(bound.low.y, -2, 2e-3);
    // The body and the bottom: away from a point within.
    for (int part : {1, 2, 5})
        for (int k = 0; k < 4; ++k)
            for (float u : {0.2f, 0.7f}) {
                const Point p = at(*surfaces[std::size_t(4 * part + k)], u, 0.5f);
                EXPECT_GT(dot(p.Ng, p.P - Vec3{0, 0, 1}), 0) << part << " " << k;
            }
    // Handle and spout: away from their middles, in y.
    for (int k = 24; k < 32; ++k) {
        const Point p = at(*surfaces[std::size_t(k)], 0.5f, 0.5f);
        EXPECT_GT(p.Ng.y * p.P.y, 0) << k;
    }
}

} // namespace
} // namespace candela
