// SPDX-License-Identifier: Apache-2.0
// A wave of paths from the camera, advanced a vertex at a time: intersect all, bin the hits by
// shader, ask in full batches, sample, connect. One wave a thread.
#pragma once

#include "light/transport/classic_light.h"
#include "light/transport/cone_mixture.h"
#include "light/transport/direct_light.h"
#include "light/transport/first_hit.h"
#include "light/transport/gathered_light.h"
#include "light/transport/hit_bins.h"
#include "light/transport/integrator.h"
#include "light/transport/non_finite.h"
#include "light/transport/path_state.h"
#include "light/transport/scattering_event.h"
#include "light/transport/surface_vertices.h"

#include <memory>

namespace candela {

/// Rays that leave surfaces to find the light there, by vertex.
struct GatheringRays {
    ConstVec3Planes origin, direction; ///< Unit directions.
    const float *time;
    const float *pdf; ///< Of the direction, per steradian.
    const int *depth; ///< Scatterings up to the vertex; the gathering is one more.
    const int *lightSet;
    const int *x, *y;                            ///< The pixel, for messages.
    const std::uint32_t *pixelKey, *sampleIndex; ///< The address of the paths' random numbers.
};

class PathWave {
public:
    /// Most paths a wave holds, and most vertices that one shader is asked about at once: the
    /// rays of a wave and the shading data of a chunk each fit a core's second-level cache.
    static constexpr int capacity = 4096, chunk = 1024;

    /// Camera: paths of pictures. Gathering: paths that find light for a shader that isn't affine
    /// in it; they end at the next one of that kind with what lights send there.
    enum class Purpose { Camera, Gathering };

    PathWave(const Scene &, const IntegratorSettings &, const PixelFilterSampler &,
             std::span<const ChannelInfo> channels, TransportStatistics &, NonFiniteReporter &,
             Purpose = Purpose::Camera);

    /// Camera paths for the samples [first, last) of `pixels` pixels (x[i], y[i]), pixel by pixel.
    void startCamera(int pixels, const int *x, const int *y, int first, int last);
    /// Paths along the rays of vertices lane[0..count), which take slots in this order.
    void startGathering(int count, const int *lane, const GatheringRays &);
    /// Follows all paths to their ends.
    void run();

    int slots() const { return slots_; }
    const PathResults &results() const { return results_; }

private:
    void traceAndShade(int iteration);
    void shadeChunk(int code, const int *order, int count, int iteration);
    void gatherState(const int *order, int count);
    void takeHistory();
    void addEmission();
    void addVisible(const int *order);
    void lightClassic(const float *const *ambient);
    void lightPath();
    void lightGathered(const float *const *ambient);
    void chooseBesidesFiniteLobes();
    void stateMixture();
    void sampleNumbers(int pair);
    void gatherLight(const float *const *contribution);
    void deliverLight();
    bool slotsAreConsecutive() const;
    void reportNonFinite(int i);
    void scatterOn();
    void append(int count, const int *lane, const float *gain, const float *pdf);
    void correctSpecialEvents(int count, const int *lane, int first);

    // The state of the chunk's paths.
    float *throughput(int c) const { return state_[c]; }
    float *gathered(int c) const { return state_[colorSamples + c]; } ///< Light at this vertex.
    float *lastPdf() const { return state_[2 * colorSamples]; }
    float *travelled() const { return state_[2 * colorSamples + 1]; } ///< Up to this vertex.
    int *slot() const { return stateIntegers_[0]; }
    int *depth() const { return stateIntegers_[1]; }
    int *lastLightSet() const { return stateIntegers_[2]; }
    int *seen() const { return stateIntegers_[3]; }

    const Scene &scene_;
    const IntegratorSettings &settings_;
    const PixelFilterSampler &filter_;
    std::vector<FirstHitPlane> firstHit_;
    TransportStatistics &statistics_;
    NonFiniteReporter &nonFinite_;
    const Purpose purpose_;

    PathResults results_;
    int slots_ = 0;
    ActivePaths active_, next_;
    HitBatch hits_;
    Planes<float> cameraNumbers_; ///< Camera pairs of the wave's samples.
    HitBins bins_;

    // One chunk of vertices.
    SurfaceVertices vertices_;
    ConeMixture mixture_;
    ScatteringEvents events_;
    DirectLight direct_;
    ClassicLight classic_;
    std::unique_ptr<GatheredLight> gatheredLight_; ///< Made when a shader first needs it.
    int iteration_ = 0;
    const int *order_ = nullptr; ///< The chunk's rays in active_ and hits_.
    bool hasHistory_ = false;    ///< lastPdf(), travelled() and lastLightSet() are taken.
    Planes<float> state_;
    Planes<int> stateIntegers_;  ///< As above; then two of the step that runs.
    Planes<std::uint32_t> keys_; ///< pixel key, sample index.
    Planes<float> random_;       ///< pairs of uniform numbers
    Planes<float> answers_;      ///< Colours: light or g, next throughput, ambient.
    Planes<float> scratch_;      ///< Of the step that runs.
};

} // namespace candela
