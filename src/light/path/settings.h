// SPDX-License-Identifier: Apache-2.0
// What estimators are told, and what they tell besides the picture.
#pragma once

#include "light/radiosity/settings.h"

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace candela {

/// The samples of a pixel that have been taken when the pass ends that begins with sample `first`:
/// passes take [0,16), [16,64), [64,128) and so on. The first is soon there to be looked at; many
/// samples of few pixels stay near each other, which on a mesh of 320,000 triangles is 4 % faster
/// than 16 a pass.
inline int passEnd(int first) {
    constexpr int looked = 16, whole = 64;
    return first < looked ? looked : (first / whole + 1) * whole;
}

namespace radiosity {
class Solution;
struct SolutionData;
} // namespace radiosity

enum class IntegratorKind { Classic, Path, Bidirectional, Radiosity };

/// What a solved scene is rendered by (DESIGN 6). Elements: the solution's light alone. Direct: its
/// indirect light, light sources are sampled. Gather: one more bounce by paths, which end on the
/// solution.
enum class FinalPass { Elements, Direct, Gather };

/// How often each kind of technique is tried, a camera sample of a pixel being once.
struct TechniqueCounts {
    double lightImage = 0; ///< Light paths, each connected with the lens wherever it is.
    double connections =
        0; ///< Whole light paths that each vertex of a camera path is connected to.
    double merging =
        0; ///< Light paths that each vertex is merged with, times the disc's area, m^2.
    /// Light paths count where `path` has no way to find the light, and nowhere else.
    bool besidePath = false;
};

/// Of `vcm`: vertices of camera paths are merged with those of light paths around them.
struct MergingPlan {
    float radius = 0;        ///< Of the first round, metres; 0 = nothing is merged.
    int samplesOfRound = 64; ///< Of a pixel: each round has light paths of its own.
    double trust = 1;        ///< In weights, what merging counts beside its number.

    bool isUsed() const { return radius > 0; }
    /// The samples of a pixel that have been taken when the round ends that begins with `first`.
    int roundEnd(int first) const { return (first / samplesOfRound + 1) * samplesOfRound; }
    /// Of that round: areas shrink by the fourth root of the rounds, so that in the end there is no
    /// bias, and few paths are merged with the later ones (Knaus and Zwicker 2011, alpha = 3/4).
    float radiusAt(int first) const {
        const double rounds = 1 + first / samplesOfRound;
        return float(radius / std::sqrt(std::sqrt(std::sqrt(rounds))));
    }
};

/// How much of each technique a frame takes.
struct BidirectionalPlan {
    double lightPaths = 0;      ///< Started for each sample of a pixel; 0 = the frame is `path`'s.
    int connections = 0;        ///< Of each vertex of a camera path.
    double verticesPerPath = 1; ///< Of light paths, as a pilot found: what a connection counts.
    double trust = 1;           ///< In weights, what light paths count beside their number.
    bool besidePath = false;    ///< Camera paths are those of `path`: see TechniqueCounts.
    MergingPlan merging{};

    TechniqueCounts counts() const {
        return {trust * lightPaths, connections > 0 ? trust * connections / verticesPerPath : 0, 0,
                besidePath};
    }
};

/// What the user decides of it, in place of pilots.
struct BidirectionalWishes {
    std::optional<double> lightPaths;
    std::optional<int> connections;
    double trust = 1;
    bool merges = false; ///< `vcm`.
    std::optional<float> radius;
    double trustInMerging = 1;
};

struct IntegratorSettings {
    IntegratorKind kind = IntegratorKind::Path;
    int lastSample = 4;  ///< Samples of each pixel, at most; one beyond the last.
    double variance = 0; ///< Of the mean of Ci in a pixel, that is small enough; 0 = none is. Not
                         ///< for Bidirectional.
    std::uint32_t seed = 0;
    int maxDepth = 64;           ///< Reflections and refractions along a path.
    bool hemisphereOnly = false; ///< --sampling hemisphere: ignore the shaders' cones.
    BidirectionalWishes bidirectional;
    FinalPass finalPass = FinalPass::Elements;
    radiosity::SolverSettings solver;
    /// A solution that need not be made again; null: it is made.
    std::shared_ptr<const radiosity::SolutionData> solved;
    /// Called with the solution before the first tile.
    std::function<void(const radiosity::Solution &)> whenSolved;
    std::array<int, 4> crop{}; ///< x0, x1, y0, y1: the pixels to render.
    bool atPoints = false;     ///< Paths begin at numbered points (PathResults::x), not in pixels.
    /// Called after each tile, from any thread, with the share done in [0,1].
    std::function<void(double)> progress;
    std::function<void(double)> solving; ///< Likewise of the solution that comes before the tiles.
};

/// What happened besides the picture, for --stats and messages. Counters of all threads.
struct TransportStatistics {
    std::atomic<std::uint64_t> paths{0}, lightPaths{0}, cameraRays{0}, bounceRays{0}, shadowRays{0};
    std::atomic<std::uint64_t> nonFiniteSamples{0};
    radiosity::SolverStatistics solver; ///< Zero unless the scene has been solved.
};

} // namespace candela
