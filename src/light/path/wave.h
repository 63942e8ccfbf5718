// SPDX-License-Identifier: Apache-2.0
// A wave of paths, advanced a vertex at a time: a plain record, on which the stages of stages.h
// work. One wave a thread.
#pragma once

#include "light/path/albedo.h"
#include "light/path/chunk.h"
#include "light/path/classic_light.h"
#include "light/path/crossing.h"
#include "light/path/escape.h"
#include "light/path/first_hit.h"
#include "light/path/gathered_light.h"
#include "light/path/hit_bins.h"
#include "light/path/non_finite.h"
#include "light/path/paths.h"
#include "light/path/pixel_shares.h"
#include "light/path/settings.h"
#include "light/path/shader_channels.h"
#include "light/path/subpath.h"
#include "world/camera/pixel_filter.h"

#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace candela {

struct EmissionGuide;
struct SolutionLight;
namespace radiosity {
class Solution;
}

/// What all waves of a frame share.
struct FrameContext {
    FrameContext(const Scene &, const IntegratorSettings &, const PixelFilterSampler &,
                 std::span<const ChannelInfo>, TransportStatistics &, DiagnosticSink &,
                 const EmissionGuide * = nullptr);
    const Scene &scene;
    const IntegratorSettings &settings;
    const PixelFilterSampler &filter;
    std::vector<FirstHitPlane> firstHit;
    ShaderChannels shaderChannels;
    TransportStatistics &statistics;
    NonFiniteReporter nonFinite;
    DiagnosticSink &diagnostics;
    const EmissionGuide *guide; ///< For paths from lights; null = nothing is known.
    const radiosity::Solution *solution = nullptr; ///< Of scenes that have been solved.
    std::once_flag refusedLight; ///< Volumes have asked for light at too many points: said.
};

/// Camera: paths of pictures. Gathering: paths that find light for a shader that isn't affine in
/// it; they end at the next one of that kind with what lights send there. Light: paths from lights.
enum class Purpose { Camera, Gathering, Light };

struct PathWave;
using Stage = void (*)(PathWave &);
/// The stages that serve the vertices of a shader.
using StageList = std::span<const Stage> (*)(const PathWave &, const ShaderCode &);

/// Branches that found no room beside the others of their vertex, and its number.
struct WaitingPaths {
    int vertex;
    ActivePaths paths;
};

struct PathWave {
    /// Most paths a wave holds: two branches of each camera path of a tile. Their rays fit a core's
    /// second-level cache.
    static constexpr int capacity = 8192;

    explicit PathWave(FrameContext &, Purpose = Purpose::Camera);
    ~PathWave();
    /// Of paths that have another end, too.
    PathWave(FrameContext &, Purpose, StageList, const TechniqueCounts &);

    FrameContext &frame;
    const Purpose purpose;
    const StageList stages;

    PathResults results;
    int slots = 0;  ///< Used.
    int vertex = 0; ///< Number of the vertex that the rays of `active` lead to, from 0.
    ActivePaths active, next;
    std::vector<WaitingPaths> waiting;
    std::vector<ActivePaths> spare; ///< Room for those that will have to wait.
    HitBatch hits;
    HitBins bins;
    Planes<float> cameraNumbers;        ///< Camera pairs of the wave's samples.
    SampleShares shares;                ///< Of their pixels.
    std::vector<std::uint8_t> rayKinds; ///< RayBatch::kinds of the active rays, where they matter.
    VertexChunk chunk;
    std::unique_ptr<ClassicLight> classic;   ///< Made when the first vertex needs it,
    std::unique_ptr<GatheredLight> gathered; ///< this too,
    std::unique_ptr<AlbedoPlanes> albedo;    ///< this,
    std::unique_ptr<Crossing> crossing;      ///< and this,
    std::unique_ptr<EscapingRays> escaping;  ///< and this.
    std::unique_ptr<Subpaths> subpaths;      ///< Null unless paths have two ends.
    std::unique_ptr<SolutionLight> solution; ///< Null unless the scene has been solved.

private:
    PathWave(FrameContext &, Purpose, StageList, bool hasTwoEnds);
};

} // namespace candela
