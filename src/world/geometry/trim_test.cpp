// SPDX-License-Identifier: Apache-2.0
// Trimmed NURBS against areas in closed form and against the rule, point by point.
#include "interface/ri/trim_record.h"
#include "world/geometry/constrained_triangulation.h"
#include "world/geometry/test_support.h"

#include <cmath>
#include <set>

namespace candela {
namespace {

using namespace geometrytest;

using Points = std::vector<std::array<float, 2>>;

struct Loops {
    TrimNumbers numbers;

    void addCurve(int order, const std::vector<float> &knots, float last,
                  const std::vector<std::array<float, 3>> &points) {
        numbers.orders.push_back(order);
        numbers.vertexCounts.push_back(int(points.size()));
        numbers.knots.insert(numbers.knots.end(), knots.begin(), knots.end());
        numbers.minima.push_back(0), numbers.maxima.push_back(last);
        for (const auto &[u, v, w] : points)
            numbers.u.push_back(u * w), numbers.v.push_back(v * w), numbers.w.push_back(w);
    }
    Loops &polygon(const Points &corners, bool isClosed = true) {
        numbers.curveCounts.push_back(1);
        std::vector<std::array<float, 3>> points;
        for (const auto &[u, v] : corners)
            points.push_back({u, v, 1});
        if (isClosed)
            points.push_back(points.front());
        std::vector<float> knots{0};
        for (std::size_t i = 0; i < points.size(); ++i)
            knots.push_back(float(i));
        knots.push_back(knots.back());
        addCurve(2, knots, knots.back(), points);
        return *this;
    }
    /// Two half circles, each one curve.
    Loops &circle(float u, float v, float radius, bool isLeft) {
        numbers.curveCounts.push_back(2);
        const float c = std::sqrt(0.5f), turn = isLeft ? 1 : -1;
        for (float side : {1.0f, -1.0f}) {
            const auto at = [&](float x, float y, float w) {
                return std::array<float, 3>{u + side * radius * x, v + side * turn * radius * y, w};
            };
            addCurve(3, {0, 0, 0, 1, 1, 2, 2, 2}, 2,
                     {at(1, 0, 1), at(1, 1, c), at(0, 1, 1), at(-1, 1, c), at(-1, 0, 1)});
        }
        return *this;
    }
};

Points rectangle(float u0, float v0, float u1, float v1, bool isLeft) {
    return isLeft ? Points{{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}}
                  : Points{{u0, v0}, {u0, v1}, {u1, v1}, {u1, v0}};
}

Attributes trimmedBy(const Loops &loops, const char *sense = nullptr) {
    std::string why;
    EXPECT_TRUE(readTrim(loops.numbers, why)) << why;
    Attributes attributes;
    keepTrim(loops.numbers, attributes);
    if (sense)
        attributes.named["trimcurve:sense"].strings = {sense};
    return attributes;
}

/// A square of 2 x 2; it may bulge. u runs from 0 to 1 and v from 0 to 4.
std::shared_ptr<const Surface> sheet(const Attributes &attributes, float bulge = 0) {
    const NuPatchRecord patch{{3, 3, {0, 0, 0, 1, 1, 1}, 0, 1},
                              {4, 3, {0, 0, 0, 2, 4, 4, 4}, 0, 4}};
    std::vector<float> p;
    for (float y : {-1.0f, -0.5f, 0.5f, 1.0f})
        for (float x : {-1.0f, 0.0f, 1.0f})
            p.insert(p.end(), {x, y, bulge * (1 - x * x) * (1 - y * y)});
    return surfaceOf(patch, {parameter("P", StorageClass::Vertex, ValueType::Point, p)},
                     attributes);
}

/// Curves over the unit square become curves over the patch's (u,v).
Loops onSheet(Loops loops) {
    for (float &v : loops.numbers.v)
        v *= 4;
    return loops;
}

struct TrimCase {
    const char *name;
    Loops loops;
    double area; ///< Of what is left of the unit square.
    const char *sense = nullptr;
};

std::vector<TrimCase> trimCases() {
    const double pi = std::numbers::pi;
    const Points outside = rectangle(0, 0, 1, 1, true);
    return {
        {"a hole", Loops().polygon(outside).circle(.5f, .5f, .25f, false), 1 - pi / 16},
        {"a hole, all the other way round",
         Loops().polygon(rectangle(0, 0, 1, 1, false)).circle(.5f, .5f, .25f, true), 1 - pi / 16},
        {"a hole, both the same way", Loops().polygon(outside).circle(.5f, .5f, .25f, true),
         1 - pi / 16},
        {"a hole by itself", Loops().circle(.4f, .6f, .25f, false), 1 - pi / 16},
        {"a disk", Loops().circle(.4f, .6f, .25f, true), pi / 16},
        {"all but a disk", Loops().circle(.4f, .6f, .25f, true), 1 - pi / 16, "outside"},
        {"a ring with an island",
         Loops()
             .circle(.5f, .5f, .4f, true)
             .circle(.5f, .5f, .3f, false)
             .circle(.5f, .5f, .1f, true),
         pi * (.16 - .09 + .01)},
        {"two disks", Loops().circle(.25f, .5f, .2f, true).circle(.75f, .5f, .2f, true), pi * .08},
        {"a disk beyond the edge", Loops().circle(0, .5f, .25f, true), pi / 32},
        {"a triangle", Loops().polygon({{.1f, .1f}, {.9f, .2f}, {.3f, .8f}}), .27},
        {"an hourglass, which crosses itself",
         Loops().polygon({{.2f, .2f}, {.8f, .8f}, {.8f, .2f}, {.2f, .8f}}), .18},
        {"halves that share an edge",
         Loops()
             .polygon(rectangle(.1f, .1f, .5f, .9f, true))
             .polygon(rectangle(.5f, .1f, .9f, .9f, true)),
         .64},
        {"the square itself", Loops().polygon(outside), 1},
    };
}

TEST(TrimmedPatches, HaveTheirClosedAreas) {
    for (const TrimCase &c : trimCases()) {
        const auto surface = sheet(trimmedBy(onSheet(c.loops), c.sense));
        ASSERT_TRUE(surface) << c.name;
        // Lengths of outlines here are below 10, and the sheet's area is 4.
        EXPECT_NEAR(surface->area(), 4 * c.area, 2e-2) << c.name;
        for (float chord : {0.1f, 1e-2f, 1e-4f}) {
            const DicedMesh mesh = surface->dice({1e9f, chord});
            EXPECT_NEAR(areaOf(mesh), 4 * c.area, 10 * std::min(chord, 2e-3f)) << c.name;
            EXPECT_EQ(surface->triangleCount({1e9f, chord}), double(mesh.triangles.size()));
        }
    }
}

TEST(TrimmedPatches, KeepTheirBoundAndHaveNoOtherBorders) {
    for (const TrimCase &c : trimCases()) {
        const auto surface = sheet(trimmedBy(onSheet(c.loops), c.sense), 0.8f);
        for (DiceRate rate : {DiceRate{1e9f, 0.3f}, {1e9f, 1e-2f}, {0.2f, 1e9f}, {1e9f, 1e-3f}}) {
            const DicedMesh mesh = surface->dice(rate);
            EXPECT_LE(sampledChordError(*surface, mesh, 3), mesh.chordError) << c.name;
            // A side with a triangle on one side of it alone has no area of the surface beyond.
            std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
            for (const auto &t : mesh.triangles)
                for (int k = 0; k < 3; ++k)
                    EXPECT_TRUE(sides.insert({t[k], t[(k + 1) % 3]}).second) << c.name;
            for (const auto &[a, b] : sides) {
                if (sides.contains({b, a}))
                    continue;
                const auto &p = mesh.vertexUv[a], &q = mesh.vertexUv[b];
                const float u = (p[0] + q[0]) / 2, v = (p[1] + q[1]) / 2;
                const float du = q[0] - p[0], dv = q[1] - p[1], length = std::hypot(du, dv);
                const float beyondU = u + 2e-3f * dv / length, beyondV = v - 2e-3f * du / length;
                if (length < 3e-2f || beyondU < 0 || beyondU > 1 || beyondV < 0 || beyondV > 1)
                    continue; // As near as outlines are followed, or the edge.
                float scale = -1;
                SurfaceAnswer answer;
                answer.areaScale = &scale;
                const std::uint32_t piece = 0;
                surface->evaluate({1, &piece, &beyondU, &beyondV}, answer);
                EXPECT_EQ(scale, 0) << c.name << " " << u << " " << v;
            }
        }
    }
}

TEST(TrimmedPatches, WithoutAreaSayWhatIsCutAway) {
    for (const TrimCase &c : trimCases()) {
        const auto surface = sheet(trimmedBy(onSheet(c.loops), c.sense));
        double sum = 0;
        constexpr int cells = 200;
        for (int i = 0; i < cells; ++i)
            for (int j = 0; j < cells; ++j) {
                const float u = (i + 0.5f) / cells, v = (j + 0.5f) / cells;
                float scale = -1;
                SurfaceAnswer answer;
                answer.areaScale = &scale;
                const std::uint32_t piece = 0;
                surface->evaluate({1, &piece, &u, &v}, answer);
                sum += scale / (cells * cells);
            }
        EXPECT_NEAR(sum, 4 * c.area, 4e-2) << c.name;
    }
}

TEST(TrimmedPatches, NameTheirPointsOverTheBoxRoundThem) {
    const auto surface = sheet(trimmedBy(onSheet(Loops().circle(.8f, .25f, .125f, true))));
    const Point middle = at(*surface, 0.5f, 0.5f);
    EXPECT_NEAR(middle.u, .8, 1e-3);
    EXPECT_NEAR(middle.v, 1, 4e-3);
    EXPECT_NEAR(middle.P.x, .6, 2e-3);
    EXPECT_NEAR(variable(*surface, "s", 0.5f, 0.5f).value[0], .8, 1e-3);
    EXPECT_NEAR(variable(*surface, "s", 0.5f, 0.5f).du[0], 1, 1e-6);
    const Point end = at(*surface, 1, 0.5f);
    EXPECT_NEAR(end.u, .925, 4e-3);
}

TEST(TrimmedPatches, OfBadLoopsAreDrawnWithAWarning) {
    const auto made = [](const Attributes &attributes) {
        DiagnosticList diagnostics;
        const NuPatchRecord patch{{2, 2, {0, 0, 1, 1}, 0, 1}, {2, 2, {0, 0, 1, 1}, 0, 1}};
        const auto surfaces =
            makeSurfaces(record(patch, {parameter("P", StorageClass::Vertex, ValueType::Point,
                                                  {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})}),
                         attributes, diagnostics);
        EXPECT_EQ(diagnostics.count(Severity::Error), 0);
        EXPECT_EQ(diagnostics.count(Severity::Warning), 1);
        return surfaces.empty() ? 0 : surfaces[0]->area();
    };
    const Points open{{.2f, .2f}, {.8f, .2f}, {.8f, .8f}, {.2f, .8f}};
    EXPECT_NEAR(made(trimmedBy(Loops().polygon(open, false))), .36, 1e-3);
    EXPECT_EQ(made(trimmedBy(Loops().polygon(rectangle(2, 2, 3, 3, true)))), 0);
}

TEST(TrimNumbersOfFiles, AreCheckedBeforeTheyAreKept) {
    const auto defect = [](auto change) {
        TrimNumbers numbers = Loops().circle(.5f, .5f, .2f, true).numbers;
        change(numbers);
        std::string why;
        return readTrim(numbers, why) ? "" : why;
    };
    EXPECT_EQ(defect([](TrimNumbers &) {}), "");
    EXPECT_EQ(defect([](TrimNumbers &n) { n = {}; }), "");
    EXPECT_NE(defect([](TrimNumbers &n) { n.curveCounts = {3}; }), "");
    EXPECT_NE(defect([](TrimNumbers &n) { n.curveCounts = {1}; }), "");
    EXPECT_NE(defect([](TrimNumbers &n) { n.curveCounts = {-1, 3}; }), "");
    EXPECT_NE(defect([](TrimNumbers &n) { n.orders[0] = 1; }), "");
    EXPECT_NE(defect([](TrimNumbers &n) { n.orders[1] = 6; }), "");
    EXPECT_NE(defect([](TrimNumbers &n) { n.vertexCounts[1] = 2147483647; }), "");
    EXPECT_NE(defect([](TrimNumbers &n) { n.knots.pop_back(); }), "");
    EXPECT_NE(defect([](TrimNumbers &n) { n.knots[4] = -1; }), "");
    EXPECT_NE(defect([](TrimNumbers &n) { n.u.push_back(1); }), "");
    EXPECT_NE(defect([](TrimNumbers &n) { n.v[2] = NAN; }), "");
    EXPECT_NE(defect([](TrimNumbers &n) { n.w[2] = 0; }), "");
    EXPECT_NE(defect([](TrimNumbers &n) { n.maxima[0] = 0; }), "");
}

/// Chains through points anywhere, on sides too, that cross themselves again and again.
TEST(ConstrainedTriangulations, CoverTheTriangleOnce) {
    using Cut = ConstrainedTriangulation;
    std::mt19937 random(1);
    for (int trial = 0; trial < 600; ++trial) {
        Cut cut;
        const std::int64_t range = trial % 3 == 0 ? 12 : trial % 3 == 1 ? 1000 : Cut::size;
        const auto number = [&] { return 1 + std::int64_t(random()) % (range - 1); };
        std::vector<int> chain;
        for (int i = 0; i < 2 + trial % 30; ++i) {
            Cut::Place place{number(), number()};
            if (i % 5 == 0)
                place.y = 0;
            if (place.x + place.y <= Cut::size)
                chain.push_back(cut.insert(place));
        }
        for (std::size_t i = 0; i + 1 < chain.size(); ++i)
            cut.constrain(chain[i], chain[i + 1]);
        std::int64_t area = 0;
        std::set<std::pair<int, int>> sides;
        for (const auto &[a, b, c] : cut.triangles()) {
            const auto p = cut.points()[a], q = cut.points()[b], r = cut.points()[c];
            const std::int64_t own = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
            EXPECT_GT(own, 0);
            area += own;
            for (auto side : {std::pair{a, b}, {b, c}, {c, a}})
                EXPECT_TRUE(sides.insert(side).second);
        }
        EXPECT_EQ(area, Cut::size * Cut::size);
    }
}

} // namespace
} // namespace candela
