// SPDX-License-Identifier: Apache-2.0
// NURBS against closed forms and against their definition, evaluated slowly.
#include "world/geometry/test_support.h"

#include <cmath>

namespace candela {
namespace {

using namespace geometrytest;

std::vector<float> evenKnots(int count, bool isClamped, int order, double power) {
    std::vector<float> knots;
    for (int i = 0; i < count; ++i) {
        double at = isClamped ? std::clamp(i, order - 1, count - order) - (order - 1.0) : i;
        knots.push_back(float(std::pow(at, power)));
    }
    return knots;
}

SplineRecord spline(int vertices, int order, std::vector<float> knots) {
    SplineRecord result{vertices, order, std::move(knots), 0, 0};
    result.low = result.knots[order - 1], result.high = result.knots[vertices];
    return result;
}

/// Cox and de Boor's recursion, as it is written in books: all basis functions at a place.
std::vector<double> basisFunctions(const SplineRecord &s, double t) {
    const auto &knots = s.knots;
    std::vector<double> n(knots.size() - 1);
    for (std::size_t i = 0; i < n.size(); ++i) {
        const bool isLast = knots[i + 1] == knots[s.vertices] && t >= knots[s.vertices];
        n[i] = knots[i] < knots[i + 1] && ((knots[i] <= t && t < knots[i + 1]) || isLast);
    }
    const auto share = [](double part, double of) { return of > 0 ? part / of : 0.0; };
    for (int order = 2; order <= s.order; ++order)
        for (std::size_t i = 0; i + order < knots.size(); ++i) {
            const double first = knots[i], last = knots[i + order];
            n[i] = share(t - first, knots[i + order - 1] - first) * n[i] +
                   share(last - t, last - knots[i + 1]) * n[i + 1];
        }
    return n;
}

/// A component of four (or one) at what shaders call (u,v).
double slowly(const NuPatchRecord &patch, const std::vector<float> &values, int n, int c, double u,
              double v) {
    const std::vector<double> alongU = basisFunctions(patch.u, u),
                              alongV = basisFunctions(patch.v, v);
    double sum = 0;
    for (int j = 0; j < patch.v.vertices; ++j)
        for (int i = 0; i < patch.u.vertices; ++i)
            sum += alongU[i] * alongV[j] * values[(std::size_t(j) * patch.u.vertices + i) * n + c];
    return sum;
}

struct SplineCase {
    std::string name;
    SplineRecord u, v;
    bool rational = false;
};

std::vector<SplineCase> splineCases() {
    auto even = [](int vertices, int order, bool isClamped, double power = 1) {
        return spline(vertices, order, evenKnots(vertices + order, isClamped, order, power));
    };
    SplineRecord part = even(9, 4, false);
    part.low = 3.25f, part.high = 7.5f;
    SplineRecord beyond = even(6, 3, true);
    beyond.low = -5, beyond.high = 50;
    SplineRecord far = even(6, 4, true);
    for (float &knot : far.knots)
        knot += 1000;
    far.low += 1000, far.high += 1000;
    std::vector<SplineCase> cases{
        {"bilinear", even(4, 2, true), even(3, 2, true)},
        {"quadratic", even(6, 3, true), even(5, 3, false)},
        {"cubic, uneven", even(8, 4, true, 1.7), even(7, 4, false)},
        {"of two orders", even(5, 2, true), even(6, 4, true)},
        {"of high orders", even(9, 7, true), even(6, 5, false)},
        {"of order 24", even(26, 24, true), even(3, 2, true)},
        {"double knots", spline(8, 4, {0, 0, 0, 0, 1, 1, 2, 3, 4, 4, 4, 4}),
         spline(7, 3, {-1, -1, -1, 0, 0, 2, 2, 5, 5, 5})},
        {"in part", part, beyond},
        {"far knots", far, even(5, 4, true)},
    };
    const std::size_t plain = cases.size();
    for (std::size_t k = 0; k < plain; ++k) {
        cases.push_back(cases[k]);
        cases.back().name += ", rational";
        cases.back().rational = true;
    }
    return cases;
}

std::vector<float> net(const SplineCase &c, int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-0.2f, 0.2f);
    std::vector<float> values;
    for (int j = 0; j < c.v.vertices; ++j)
        for (int i = 0; i < c.u.vertices; ++i) {
            const float w = c.rational ? 1 + uniform(random) : 1;
            const float at[] = {float(i), float(j), 0, 1};
            for (int k = 0; k < n; ++k)
                values.push_back((k == 3 ? 1 : at[k] + uniform(random)) * w);
        }
    return values;
}

std::shared_ptr<const Surface> made(const SplineCase &c, std::vector<Parameter> more = {}) {
    more.push_back(parameter(c.rational ? "Pw" : "P", StorageClass::Vertex,
                             c.rational ? ValueType::HPoint : ValueType::Point,
                             net(c, c.rational ? 4 : 3, 5)));
    return surfaceOf(NuPatchRecord{c.u, c.v}, std::move(more));
}

float lowOf(const SplineRecord &s) { return std::max(s.low, s.knots[s.order - 1]); }
float highOf(const SplineRecord &s) { return std::min(s.high, s.knots[s.vertices]); }

TEST(NuPatches, AgreeWithTheirDefinition) {
    for (const SplineCase &c : splineCases()) {
        const NuPatchRecord patch{c.u, c.v};
        const std::vector<float> points = net(c, c.rational ? 4 : 3, 5);
        std::vector<float> weights = randomFloats(c.u.vertices * c.v.vertices, 8);
        const auto surface =
            made(c, {parameter("heat", StorageClass::Vertex, ValueType::Float, weights)});
        for (float a : {0.0f, 0.13f, 0.25f, 0.5f, 0.77f, 1.0f})
            for (float b : {0.0f, 0.31f, 0.6f, 0.999f}) {
                const Point p = at(*surface, a, b);
                // u and v run over the knots that are drawn.
                EXPECT_NEAR(p.u, lowOf(c.u) + a * (highOf(c.u) - lowOf(c.u)), 2e-4) << c.name;
                EXPECT_NEAR(p.v, lowOf(c.v) + b * (highOf(c.v) - lowOf(c.v)), 2e-4) << c.name;
                const double u = lowOf(c.u) + double(a) * (highOf(c.u) - lowOf(c.u));
                const double v = lowOf(c.v) + double(b) * (highOf(c.v) - lowOf(c.v));
                const auto component = [&](int k, double du, double dv) {
                    return slowly(patch, points, c.rational ? 4 : 3, k, u + du, v + dv);
                };
                const double w = c.rational ? component(3, 0, 0) : 1;
                for (int k = 0; k < 3; ++k)
                    EXPECT_NEAR(p.P[k], component(k, 0, 0) / w, 4e-5) << c.name << " " << a << b;
                EXPECT_NEAR(variable(*surface, "heat", a, b).value[0],
                            slowly(patch, weights, 1, 0, u, v), 2e-5)
                    << c.name;
            }
    }
}

/// By what shaders call u and v. Central differences in double, away from knots.
TEST(NuPatches, DerivativesAreByTheirParameters) {
    const double h = 1e-4;
    for (const SplineCase &c : splineCases()) {
        const NuPatchRecord patch{c.u, c.v};
        const int n = c.rational ? 4 : 3;
        const std::vector<float> points = net(c, n, 5);
        const auto surface = made(c, {parameter("heat", StorageClass::Vertex, ValueType::Float,
                                                randomFloats(c.u.vertices * c.v.vertices, 8))});
        const auto place = [&](double u, double v) {
            const double w = c.rational ? slowly(patch, points, n, 3, u, v) : 1;
            Vec3 p;
            for (int k = 0; k < 3; ++k)
                p[k] = float(slowly(patch, points, n, k, u, v) / w);
            return p;
        };
        for (float a : {0.137f, 0.521f, 0.883f})
            for (float b : {0.211f, 0.717f}) {
                const Point p = at(*surface, a, b);
                const double u = lowOf(c.u) + double(a) * (highOf(c.u) - lowOf(c.u));
                const double v = lowOf(c.v) + double(b) * (highOf(c.v) - lowOf(c.v));
                const Vec3 du = (place(u + h, v) - place(u - h, v)) / float(2 * h);
                const Vec3 dv = (place(u, v + h) - place(u, v - h)) / float(2 * h);
                // Differences of floats: 6e-8 of some metres over 2e-4.
                EXPECT_LT(length(p.dPdu - du), 1e-2 * (1 + length(du))) << c.name << " " << a;
                EXPECT_LT(length(p.dPdv - dv), 1e-2 * (1 + length(dv))) << c.name << " " << b;
                const float step = 1e-3f;
                const Value before = variable(*surface, "heat", a - step, b);
                const Value after = variable(*surface, "heat", a + step, b);
                const float slope =
                    (after.value[0] - before.value[0]) / (2 * step * (highOf(c.u) - lowOf(c.u)));
                EXPECT_NEAR(variable(*surface, "heat", a, b).du[0], slope, 2e-2) << c.name;
            }
    }
}

TEST(NuPatches, ChordErrorIsCertifiedAndSpansShareTheirEdges) {
    for (const SplineCase &c : splineCases()) {
        const auto surface = made(c);
        for (float chord : {0.3f, 0.03f, 3e-3f}) {
            const DicedMesh mesh = surface->dice({1e9f, chord});
            EXPECT_LE(mesh.chordError, chord + 1e-4f) << c.name;
            EXPECT_LE(sampledChordError(*surface, mesh, 3), mesh.chordError) << c.name;
            // One border, as long as the outline.
            const std::size_t vertices = mesh.positions.size();
            const int border = borderEdges(mesh);
            EXPECT_EQ(int(mesh.triangles.size()), 2 * int(vertices) - 2 - border) << c.name;
        }
    }
}

/// A quarter of a turn is a rational parabola with the weights 1, cos 45, 1.
struct Circle {
    SplineRecord spline{9, 3, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, 0, 4};
    /// Homogeneous, in turns of a quarter.
    static std::array<double, 3> vertex(int i) {
        static constexpr int x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1};
        static constexpr int y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
        const double w = i % 2 ? std::sqrt(0.5) : 1;
        return {x[i] * w, y[i] * w, w};
    }
};

/// A profile (radius, height, weight), turned about z.
std::shared_ptr<const Surface> turned(const std::vector<std::array<double, 3>> &profile,
                                      const SplineRecord &along) {
    const Circle circle;
    std::vector<float> points;
    for (const auto &[r, z, w] : profile)
        for (int i = 0; i < 9; ++i) {
            const auto [x, y, c] = circle.vertex(i);
            for (double number : {x * r, y * r, z * c, w * c})
                points.push_back(float(number));
        }
    return surfaceOf(NuPatchRecord{circle.spline, along},
                     {parameter("Pw", StorageClass::Vertex, ValueType::HPoint, points)});
}

struct Turned {
    const char *name;
    std::shared_ptr<const Surface> surface;
    double area;
    double (*implicit)(double x, double y, double z); ///< Length from the surface.
    int borders;                                      ///< Of circles.
};

std::vector<Turned> bodies() {
    const double c = std::sqrt(0.5), pi = std::numbers::pi;
    const SplineRecord line{2, 2, {0, 0, 1, 1}, 0, 1};
    const SplineRecord half{5, 3, {0, 0, 0, 1, 1, 2, 2, 2}, 0, 2};
    std::vector<std::array<double, 3>> ring;
    for (int i = 0; i < 9; ++i) {
        const auto [x, z, w] = Circle::vertex(i);
        ring.push_back({2 * w + 0.5 * x, 0.5 * z, w});
    }
    return {
        {"cylinder", turned({{1, -1, 1}, {1, 2, 1}}, line), 6 * pi,
         [](double x, double y, double) { return std::hypot(x, y) - 1; }, 2},
        {"cone", turned({{1, 0, 1}, {0, 2, 1}}, line), pi * std::sqrt(5.0),
         [](double x, double y, double z) { return std::hypot(x, y) - (1 - z / 2); }, 1},
        {"sphere", turned({{0, -1, 1}, {c, -c, c}, {1, 0, 1}, {c, c, c}, {0, 1, 1}}, half), 4 * pi,
         [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z) - 1; }, 0},
        {"torus", turned(ring, Circle{}.spline), 4 * pi * pi * 2 * 0.5,
         [](double x, double y, double z) { return std::hypot(std::hypot(x, y) - 2, z) - 0.5; }, 0},
    };
}

TEST(NuPatchesOfRevolution, AreTheQuadrics) {
    for (const Turned &body : bodies()) {
        EXPECT_NEAR(body.surface->area() / body.area, 1, 2e-5) << body.name;
        for (float u : {0.0f, 0.1f, 0.25f, 0.6f, 1.0f})
            for (float v : {0.0f, 0.2f, 0.5f, 0.9f, 1.0f}) {
                const Point p = at(*body.surface, u, v);
                EXPECT_NEAR(body.implicit(p.P.x, p.P.y, p.P.z), 0, 1e-6) << body.name;
                ASSERT_TRUE(isFinite(p.Ng) && length(p.Ng) > 0) << body.name << " " << u << v;
                // The normal is the gradient of the distance, at poles that of a place beside.
                const double h = 1e-3;
                Vec3 gradient;
                for (int k = 0; k < 3; ++k) {
                    double low[] = {p.P.x, p.P.y, p.P.z}, high[] = {p.P.x, p.P.y, p.P.z};
                    low[k] -= h, high[k] += h;
                    gradient[k] = float((body.implicit(high[0], high[1], high[2]) -
                                         body.implicit(low[0], low[1], low[2])) /
                                        (2 * h));
                }
                const bool isApex = body.name == std::string("cone") && v == 1;
                if (!isApex) {
                    EXPECT_GT(std::abs(dot(normalize(p.Ng), normalize(gradient))), 1 - 1e-4)
                        << body.name << " " << u << " " << v;
                }
            }
    }
}

TEST(NuPatchesOfRevolution, CloseAtTheirSeams) {
    for (const Turned &body : bodies())
        for (float chord : {0.2f, 0.01f, 2e-3f}) {
            const DicedMesh mesh = body.surface->dice({1e9f, chord});
            const int border = borderEdges(mesh);
            EXPECT_EQ(border == 0, body.borders == 0) << body.name << " " << chord;
            EXPECT_LE(sampledChordError(*body.surface, mesh, 3), mesh.chordError) << body.name;
            EXPECT_EQ(body.surface->triangleCount({1e9f, chord}), double(mesh.triangles.size()))
                << body.name;
        }
}

/// RI 3.2, 5.2: counts are by segments, empty ones of multiple knots included.
TEST(NuPatches, VariablesAreThoseOfSegments) {
    SplineCase c{"", spline(6, 3, {0, 0, 0, 1, 1, 2, 3, 3, 3}), spline(2, 2, {0, 0, 1, 1})};
    std::vector<float> uniform{10, 11, 12, 13}, varying, corners;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 5; ++i)
            varying.push_back(float(i + 10 * j));
    for (int i = 0; i < 4; ++i)
        corners.insert(corners.end(), {float(i), i + 0.5f, 100.0f + i, 100.5f + i});
    const auto surface =
        made(c, {parameter("face", StorageClass::Uniform, ValueType::Float, uniform),
                 parameter("even", StorageClass::Varying, ValueType::Float, varying),
                 parameter("corner", StorageClass::FaceVarying, ValueType::Float, corners),
                 parameter("one", StorageClass::Constant, ValueType::Float, {7}),
                 parameter("whole", StorageClass::Varying, ValueType::Float, {1, 4, 10, 40})});
    // Segments run over [0,1], [1,1], [1,2] and [2,3].
    const struct {
        float u;
        int segment;
        float share;
    } places[] = {{0.1f, 0, 0.3f}, {0.5f, 2, 0.5f}, {0.9f, 3, 0.7f}};
    for (const auto &[u, segment, share] : places) {
        EXPECT_FLOAT_EQ(variable(*surface, "face", u, 0.5f).value[0], uniform[segment]);
        EXPECT_NEAR(variable(*surface, "even", u, 0.25f).value[0], segment + share + 2.5, 1e-4);
        EXPECT_NEAR(variable(*surface, "corner", u, 0).value[0], segment + share / 2, 1e-4);
        EXPECT_NEAR(variable(*surface, "corner", u, 1).value[0], 100 + segment + share / 2, 1e-4);
        EXPECT_FLOAT_EQ(variable(*surface, "one", u, 0.5f).value[0], 7);
        // Four values are those of the corners of all that is drawn.
        EXPECT_NEAR(variable(*surface, "whole", u, 0).value[0], 1 + 3 * u, 1e-5);
        EXPECT_NEAR(variable(*surface, "whole", u, 1).value[0], 10 + 30 * u, 1e-5);
        EXPECT_NEAR(variable(*surface, "whole", u, 0).du[0], 1, 1e-5); // u runs to 3.
        // Texture coordinates go from corner to corner of what is drawn.
        EXPECT_NEAR(variable(*surface, "s", u, 0.5f).value[0], u, 1e-6);
        EXPECT_NEAR(variable(*surface, "s", u, 0.5f).du[0], 1 / 3.0f, 1e-6);
    }
}

} // namespace
} // namespace candela
