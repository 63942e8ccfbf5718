// SPDX-License-Identifier: Apache-2.0
// Polygons that cross themselves cover what they wind around an odd number of times; large ones
// take their time and no more.
#include "world/geometry/polygon_surface.h"
#include "world/geometry/test_support.h"
#include "world/geometry/triangulate.h"

#include <cmath>
#include <ctime>

namespace candela {
namespace {

using namespace geometrytest;

using Loop = std::vector<std::array<double, 2>>;

struct Covered {
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    TriangulationResult result;
    double seconds; ///< Of the processor.

    double area() const {
        double sum = 0;
        for (std::size_t k = 0; k < triangles.size(); ++k)
            sum += turnOf(k, points[triangles[k][2]].x, points[triangles[k][2]].y, 0) / 2;
        return std::abs(sum);
    }
    /// Of side `side` of a triangle and a place.
    double turnOf(std::size_t triangle, double x, double y, int side) const {
        const Vec3 a = points[triangles[triangle][std::size_t(side)]];
        const Vec3 b = points[triangles[triangle][std::size_t((side + 1) % 3)]];
        return (double(b.x) - a.x) * (y - a.y) - (double(b.y) - a.y) * (x - a.x);
    }
    int layersAt(double x, double y) const {
        int layers = 0;
        for (std::size_t k = 0; k < triangles.size(); ++k) {
            const double p = turnOf(k, x, y, 0), q = turnOf(k, x, y, 1), r = turnOf(k, x, y, 2);
            layers += (p > 0 && q > 0 && r > 0) || (p < 0 && q < 0 && r < 0);
        }
        return layers;
    }
};

Covered cover(const std::vector<Loop> &loops) {
    Covered covered;
    std::vector<std::vector<int>> indices;
    for (const Loop &loop : loops) {
        indices.emplace_back();
        for (const auto &p : loop) {
            indices.back().push_back(int(covered.points.size()));
            covered.points.push_back({float(p[0]), float(p[1]), 0});
        }
    }
    const std::vector<std::span<const int>> spans(indices.begin(), indices.end());
    std::vector<MadeCorner> made;
    const std::clock_t start = std::clock();
    covered.result = triangulate(covered.points, spans, covered.triangles, made);
    covered.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    for (const MadeCorner &corner : made) {
        const Vec3 a = covered.points[std::size_t(corner.between[0])];
        const Vec3 b = covered.points[std::size_t(corner.between[1])];
        covered.points.push_back(a + (b - a) * float(corner.share));
    }
    return covered;
}

/// n corners on the unit circle, each joined to the k-th after it.
Loop starPolygon(int n, int k) {
    Loop loop;
    for (long i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * double(i * k % n) / n;
        loop.push_back({std::cos(angle), std::sin(angle)});
    }
    return loop;
}

TEST(CrossingPolygons, CoverTheirClosedForms) {
    struct Row {
        const char *name;
        std::vector<Loop> loops;
        double area;
    };
    // The star {5/2}: its ten outer triangles, without the pentagon that is wound around twice.
    const double inner = (3 - std::sqrt(5.0)) / 2, fifth = std::numbers::pi / 5;
    const double pentagram =
        5 * inner * std::sin(fifth) - 2.5 * inner * inner * std::sin(2 * fifth);
    const Loop square{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, bow{{0, 0}, {4, 4}, {4, 0}, {0, 4}};
    for (const Row &row :
         {Row{"bow tie", {bow}, 8},
          Row{"uneven bow tie", {{{0, 0}, {4, 4}, {4, 0}, {0, 2}}}, 20 / 3.},
          Row{"pentagram", {starPolygon(5, 2)}, pentagram},
          Row{"twice round", {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}}, 0},
          Row{"crossing at a corner", {{{0, 0}, {2, 2}, {4, 4}, {4, 0}, {2, 2}, {0, 4}}}, 8},
          Row{"there and back", {{{0, 0}, {2, 0}, {2, -3}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}}, 16},
          Row{"a hole by a bridge",
              {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}}},
              15},
          Row{"a hole across a side", {square, {{3, 1}, {6, 1}, {6, 3}, {3, 3}}}, 14},
          Row{"holes that overlap",
              {square, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}, {{0.5, 1}, {1, 1}, {1, 3}, {0.5, 3}}},
              11},
          Row{"a hole in a bow tie", {bow, {{0.2, 1.5}, {1.2, 2}, {0.2, 2.5}}}, 7.5},
          Row{"a hole that crosses itself", {square, {{1, 1}, {3, 3}, {3, 1}, {1, 3}}}, 14}}) {
        for (bool isTurned : {false, true}) {
            std::vector<Loop> loops = row.loops;
            if (isTurned)
                for (Loop &loop : loops)
                    std::ranges::reverse(loop);
            const Covered covered = cover(loops);
            EXPECT_NEAR(covered.area(), row.area, 2e-6 * (1 + row.area)) << row.name;
            EXPECT_EQ(covered.result,
                      row.area > 0 ? TriangulationResult::Good : TriangulationResult::Degenerate)
                << row.name;
        }
    }
}

bool windsOddly(const Loop &loop, double x, double y) {
    bool odd = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto a = loop[i], b = loop[(i + 1) % loop.size()];
        if ((a[1] <= y) != (b[1] <= y) && a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) < x)
            odd = !odd;
    }
    return odd;
}

/// Scribbles of all kinds, on a coarse grid too, where sides lie upon each other and three meet.
TEST(CrossingPolygons, CoverEachPlaceOnceOrNot) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int trial = 0; trial < 300; ++trial) {
        const auto number = [&](bool isCoarse) {
            const double x = uniform(random);
            return double(isCoarse ? std::floor(5 * x) / 4 : float(x));
        };
        Loop outside, hole;
        for (int i = 0; i < 4 + trial % 20; ++i)
            outside.push_back({number(trial % 3 == 0), number(trial % 3 == 0)});
        for (int i = 0; i < 3 + trial % 4; ++i)
            hole.push_back({number(false), number(false)});
        const bool isHoled = trial % 2 == 1;
        const Covered covered =
            cover(isHoled ? std::vector<Loop>{outside, hole} : std::vector<Loop>{outside});
        int wrong = 0;
        for (int k = 0; k < 300; ++k) {
            const double x = 1.2 * uniform(random) - 0.1, y = 1.2 * uniform(random) - 0.1;
            const bool isIn = windsOddly(outside, x, y) && !(isHoled && windsOddly(hole, x, y));
            wrong += covered.layersAt(x, y) != int(isIn);
        }
        EXPECT_LE(wrong, 1) << trial; // On the rounding of a made corner, at most.
    }
}

double areaOfLoop(const Loop &loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto p = loop[i], q = loop[(i + 1) % loop.size()];
        sum += p[0] * q[1] - p[1] * q[0];
    }
    return std::abs(sum) / 2;
}

/// Some seconds of the processor are ten times what they take.
TEST(LargePolygons, OfAHundredThousandCornersAreSoonCut) {
    constexpr int n = 100000;
    constexpr double seconds = 8;
    const auto spiral = [](int perTurn, double width) {
        Loop loop;
        const auto add = [&](int i, double offset) {
            const double angle = 2 * std::numbers::pi * i / perTurn;
            const double r = 1 + double(i) / perTurn + offset;
            loop.push_back({float(r * std::cos(angle)), float(r * std::sin(angle))});
        };
        for (int i = 0; i < n / 2; ++i)
            add(i, 0);
        for (int i = n / 2 - 1; i >= 0; --i)
            add(i, width);
        return loop;
    };
    Loop star, comb{{0, -1}, {n / 2, -1}};
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n, r = i % 2 ? 1 : 0.5;
        star.push_back({float(r * std::cos(angle)), float(r * std::sin(angle))});
    }
    for (int i = n / 2 - 1; i >= 0; --i) {
        comb.push_back({i + 0.75, 50});
        comb.push_back({i + 0.25, 0});
    }
    for (const Loop &loop : {spiral(50, .5), spiral(6, .3), star, comb}) {
        const Covered covered = cover({loop});
        EXPECT_LT(covered.seconds, seconds);
        EXPECT_EQ(covered.result, TriangulationResult::Good);
        EXPECT_EQ(covered.triangles.size(), loop.size() - 2);
        EXPECT_NEAR(covered.area() / areaOfLoop(loop), 1, 1e-5);
    }
    EXPECT_LT(cover({starPolygon(10001, 2)}).seconds, seconds);
    // Of 2.5 thousand million crossings some picture, and no wait.
    const Covered dense = cover({starPolygon(100001, 50000)});
    EXPECT_LT(dense.seconds, seconds);
    EXPECT_EQ(dense.result, TriangulationResult::Approximated);
    EXPECT_FALSE(dense.triangles.empty());
    std::vector<Loop> sieve{{{0, 0}, {201, 0}, {201, 201}, {0, 201}}};
    for (int i = 0; i < 10000; ++i) {
        const double x = 1 + 2 * (i % 100), y = 1 + 2 * (i / 100);
        sieve.push_back({{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
    }
    const Covered holed = cover(sieve);
    EXPECT_LT(holed.seconds, seconds);
    EXPECT_NEAR(holed.area(), 201 * 201 - 10000, 1e-6);
}

/// Corners that are made have the values of their side there.
TEST(CrossingPolygons, CarryVariablesAndMove) {
    const PolygonsRecord faces{{1, 1}, {4, 3}, {0, 1, 2, 3, 1, 2, 4}};
    const std::vector<float> P{0, 0, 1, 4, 4, 1, 4, 0, 1, 0, 4, 1, 8, 2, 1};
    const std::vector<float> x{0, 4, 4, 0, 8};
    const std::vector<float> xOfCorners{0, 4, 4, 0, 4, 4, 8};
    const auto of = [](const char *name, StorageClass storage, std::vector<float> values) {
        return parameter(name, storage, ValueType::Float, std::move(values));
    };
    const auto points = parameter("P", StorageClass::Vertex, ValueType::Point, P);
    const auto surface = surfaceOf(faces, {points, of("vertex", StorageClass::Vertex, x),
                                           of("corner", StorageClass::FaceVarying, xOfCorners),
                                           of("face", StorageClass::Uniform, {1, 2})});
    EXPECT_NEAR(surface->area(), 8 + 8, 1e-5);
    for (std::uint32_t piece = 0; piece < surface->domain().pieces; ++piece)
        for (auto [u, v] : {std::pair(0.f, 0.f), {1.f, 0.f}, {0.f, 1.f}, {0.2f, 0.3f}}) {
            const Point p = at(*surface, u, v, piece);
            for (const char *name : {"vertex", "corner"})
                EXPECT_NEAR(variable(*surface, name, u, v, piece).value[0], p.P.x, 1e-5) << name;
        }
    for (std::uint32_t piece = 0; piece < surface->domain().pieces; ++piece)
        EXPECT_EQ(variable(*surface, "face", 0.3f, 0.3f, piece).value[0],
                  at(*surface, 0.3f, 0.3f, piece).P.x > 4 ? 2 : 1);
    // Moving, it keeps its triangles.
    auto moving = record(faces, {points});
    std::vector<float> lifted = P;
    for (std::size_t i = 0; i < lifted.size(); i += 3)
        lifted[i] *= 2, lifted[i + 2] += 3;
    DiagnosticList diagnostics;
    const auto still =
        PolygonSurface(*triangulateFaces(faces, *moving, diagnostics), *moving, diagnostics);
    const auto moved = still.movedTo(
        *record(faces, {parameter("P", StorageClass::Vertex, ValueType::Point, lifted)}),
        diagnostics);
    ASSERT_TRUE(moved);
    EXPECT_EQ(diagnostics.text(), "");
    EXPECT_NEAR(moved->area(), 2 * still.area(), 1e-4);
    for (std::uint32_t piece = 0; piece < still.domain().pieces; ++piece) {
        const Vec3 from = at(still, 0.3f, 0.3f, piece).P, to = at(*moved, 0.3f, 0.3f, piece).P;
        EXPECT_LT(length(to - Vec3{2 * from.x, from.y, from.z + 3}), 1e-5);
    }
}

} // namespace
} // namespace candela
