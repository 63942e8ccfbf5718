// SPDX-License-Identifier: Apache-2.0
// The weights of all techniques that find a path add up to one, and each is what the densities of
// all of them say, multiplied out: over random paths of all kinds.
#include "light/path/techniques.h"

#include "light/sampling/mis.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace candela {
namespace {

enum class Lamp { Surface, Point, Distant, Sky };

/// A path x_0 to x_k, and what both ends make of each vertex. Edge i leads from x_i to x_(i+1).
struct RandomPath {
    struct Edge {
        double distance, cosine, farCosine; ///< Cosines at x_i and at x_(i+1).
    };
    struct Vertex {
        bool isFinite = true;
        bool lightPasses = true;
        /// Densities per steradian towards x_(i+1), of light, and towards x_(i-1), of the eye.
        double forward = 1, back = 1;
    };
    Lamp lamp;
    bool isParallel; ///< The camera.
    double cameraPdf;
    /// With which light samples choose the lamp, and a path begins on it; in what direction.
    double chosen, sampled, begun, direction, skyPdf;
    TechniqueCounts counts;
    std::vector<Edge> edges;
    std::vector<Vertex> vertices;

    int last() const { return int(edges.size()); } // k
    bool isInfinite() const { return lamp == Lamp::Distant || lamp == Lamp::Sky; }
    bool shows() const { return lamp == Lamp::Surface || lamp == Lamp::Sky; }
    double perArea(int edge) const {
        const bool parallel = edge == 0 ? isInfinite() : edge + 1 == last() && isParallel;
        return parallel ? 1 : 1 / square(edges[std::size_t(edge)].distance);
    }
    const Vertex &vertex(int i) const { return vertices[std::size_t(i)]; }
    const Edge &edge(int i) const { return edges[std::size_t(i)]; }
    bool isFinite(int i) const { return vertex(i).isFinite; }

    /// Of x_i, from the light and from the eye.
    double fromLight(int i) const {
        if (i == 0)
            return lamp == Lamp::Sky ? begun * skyPdf : begun;
        const double pdf = i == 1 ? direction : vertex(i - 1).forward;
        return pdf * edge(i - 1).farCosine * perArea(i - 1);
    }
    double fromEye(int i) const {
        const double pdf = i + 1 == last() ? cameraPdf : vertex(i + 1).back;
        if (i == 0 && isInfinite())
            return pdf;
        return pdf * edge(i).cosine * perArea(i);
    }
    /// Of x_0, by light samples.
    double bySample() const {
        switch (lamp) {
        case Lamp::Surface: return sampled * edge(0).cosine * perArea(0);
        case Lamp::Sky: return chosen * skyPdf;
        case Lamp::Point:
        case Lamp::Distant: break;
        }
        return chosen;
    }
    /// Light gets as far as x_i, on from all before.
    bool lightReaches(int i) const {
        for (int k = 1; k < i; ++k)
            if (!vertex(k).lightPasses)
                return false;
        return true;
    }
};

RandomPath randomPath(std::mt19937 &random, Lamp lamp, int edges) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto often = [&](double share) { return between(0, 1) < share; };
    RandomPath path;
    path.lamp = lamp, path.isParallel = often(.3), path.cameraPdf = between(.1, 3);
    path.chosen = between(.05, 1), path.sampled = between(.01, 3), path.begun = between(.05, 1);
    path.direction = between(.05, 2), path.skyPdf = between(.05, 3);
    path.counts = {between(.1, 2), often(.7) ? between(.1, 3) : 0, often(.5) ? between(.01, 1) : 0};
    for (int i = 0; i < edges; ++i) {
        path.edges.push_back({between(.3, 3), between(.1, 1), between(.1, 1)});
        RandomPath::Vertex vertex;
        vertex.isFinite = i == 0 || often(.6);
        vertex.lightPasses = vertex.isFinite || often(.8);
        if (i > 0 && vertex.isFinite)
            vertex.forward = between(.05, 2), vertex.back = between(.05, 2);
        path.vertices.push_back(vertex);
    }
    return path;
}

struct Technique {
    std::string name;
    double density; ///< Times how often it is tried.
    double weight;  ///< As the renderer has it.
};

/// What the renderer knows at all vertices, from either end.
struct Ends {
    std::vector<PathVertex> ofEye, ofLight;

    explicit Ends(const RandomPath &path)
        : ofEye(path.vertices.size()), ofLight(path.vertices.size()) {
        PathEdge edge = edgeOfCamera(path.counts, path.cameraPdf, path.isParallel);
        for (int i = path.last() - 1; i >= 0; --i) {
            PathVertex &here = ofEye[std::size_t(i)];
            here = i == 0 && path.isInfinite()
                       ? arriveAtSky(edge)
                       : arriveAlong(edge, path.edge(i).cosine, path.edge(i).distance);
            if (i == 0)
                break;
            const RandomPath::Vertex &vertex = path.vertex(i);
            edge = leaveAlong(here,
                              {vertex.isFinite, vertex.lightPasses, false, vertex.back,
                               vertex.forward, path.edge(i - 1).farCosine},
                              path.counts);
        }
        const bool isSurface = path.lamp == Lamp::Surface;
        edge = edgeOfLight({path.begun, path.direction, path.isInfinite(),
                            isSurface ? path.edge(0).cosine : 0,
                            path.lamp == Lamp::Sky ? path.skyPdf : 0});
        for (int i = 1; i < path.last() && path.lightReaches(i); ++i) {
            PathVertex &here = ofLight[std::size_t(i)];
            here = arriveAlong(edge, path.edge(i - 1).farCosine, path.edge(i - 1).distance);
            if (i == 1)
                here.last = lastOfLit(here, isSurface ? path.sampled : path.chosen, isSurface);
            const RandomPath::Vertex &vertex = path.vertex(i);
            edge = leaveAlong(
                here,
                {vertex.isFinite, true, i == 1, vertex.forward, vertex.back, path.edge(i).cosine},
                path.counts);
        }
    }
};

/// The first s vertices come from the light.
double densityOf(const RandomPath &path, int s) {
    double density = 1;
    for (int i = 0; i < path.last(); ++i)
        density *= i < s ? path.fromLight(i) : path.fromEye(i);
    return density;
}

/// Lights without extent have no density; directions that have no choice meet no competition.
double weightBesideLightSample(const RandomPath &path, bool isSample) {
    if (!path.shows() || !path.isFinite(1))
        return 1;
    const float light = float(path.lamp == Lamp::Sky ? path.chosen * path.skyPdf : path.sampled);
    const float direction = float(path.vertex(1).back);
    return isSample ? misWeight(light, direction) : misWeight(direction, light);
}

std::vector<Technique> techniquesOf(const RandomPath &path) {
    std::vector<Technique> all;
    const Ends ends(path);
    const int k = path.last();
    const TechniqueCounts &counts = path.counts;
    const bool isSky = path.lamp == Lamp::Sky;
    if (path.shows())
        all.push_back(
            {"emission", densityOf(path, 0),
             misWeightAmong(weightBesideLightSample(path, false),
                            othersOfEmission(ends.ofEye[0], path.begun * (isSky ? path.skyPdf : 1),
                                             path.direction))});
    if (path.isFinite(1)) {
        double started = path.begun * path.direction * path.edge(0).farCosine;
        started /= path.lamp == Lamp::Surface ? path.sampled * path.edge(0).cosine
                   : path.lamp == Lamp::Point ? path.chosen * square(path.edge(0).distance)
                                              : path.chosen;
        all.push_back({"light sample", densityOf(path, 1) / path.fromLight(0) * path.bySample(),
                       misWeightAmong(weightBesideLightSample(path, true),
                                      othersOfLightSample(ends.ofEye[1], counts, started,
                                                          path.vertex(1).forward))});
    }
    for (int s = 2; s < k; ++s) {
        const int near = s - 1, far = s;
        if (!path.isFinite(near) || !path.isFinite(far) || !path.lightReaches(near) ||
            counts.connections == 0)
            continue;
        all.push_back(
            {"connection " + std::to_string(s), counts.connections * densityOf(path, s),
             misWeightAmong(1, othersOfConnection({ends.ofEye[std::size_t(far)],
                                                   path.fromLight(far), path.vertex(far).forward},
                                                  {ends.ofLight[std::size_t(near)],
                                                   path.fromEye(near), path.vertex(near).back},
                                                  counts))});
    }
    if (path.isFinite(k - 1) && path.lightReaches(k - 1))
        all.push_back(
            {"light image", counts.lightImage * densityOf(path, k),
             misWeightAmong(1, othersOfLightImage({ends.ofLight[std::size_t(k) - 1],
                                                   path.fromEye(k - 1), path.vertex(k - 1).back},
                                                  counts))});
    for (int m = 1; m < k; ++m)
        if (path.isFinite(m) && path.lightReaches(m) && counts.merging > 0)
            all.push_back({"merging " + std::to_string(m),
                           counts.merging * densityOf(path, m + 1) * path.fromEye(m),
                           misWeightAmong(1, othersOfMerging(ends.ofEye[std::size_t(m)],
                                                             path.vertex(m).forward,
                                                             ends.ofLight[std::size_t(m)],
                                                             path.vertex(m).back, counts))});
    return all;
}

class Techniques : public testing::TestWithParam<std::tuple<Lamp, int>> {};

TEST_P(Techniques, HaveWeightsThatAddUpToOne) {
    const auto [lamp, edges] = GetParam();
    std::mt19937 random(unsigned(edges * 4 + int(lamp)));
    int asked = 0;
    for (int turn = 0; turn < 5000; ++turn) {
        const RandomPath path = randomPath(random, lamp, edges);
        const std::vector<Technique> all = techniquesOf(path);
        if (all.empty())
            continue;
        ++asked;
        double sum = 0, squares = 0;
        for (const Technique &technique : all)
            sum += technique.weight, squares += square(technique.density);
        ASSERT_NEAR(sum, 1, 1e-5) << turn;
        for (const Technique &technique : all)
            ASSERT_NEAR(technique.weight, square(technique.density) / squares, 1e-5)
                << turn << ": " << technique.name << " of " << all.size();
    }
    EXPECT_GT(asked, 2000);
}

std::string nameOf(const testing::TestParamInfo<std::tuple<Lamp, int>> &info) {
    static constexpr const char *names[] = {"Surface", "Point", "Distant", "Sky"};
    const auto [lamp, edges] = info.param;
    return names[int(lamp)] + std::to_string(edges - 1) + "Vertices";
}

INSTANTIATE_TEST_SUITE_P(All, Techniques,
                         testing::Combine(testing::Values(Lamp::Surface, Lamp::Point, Lamp::Distant,
                                                          Lamp::Sky),
                                          testing::Range(2, 8)),
                         nameOf);

} // namespace
} // namespace candela
