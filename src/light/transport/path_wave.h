// SPDX-License-Identifier: Apache-2.0
// A wave of paths from the camera, advanced a vertex at a time: intersect all, bin the hits by
// shader, ask in full batches, sample, connect. One wave a thread.
#pragma once

#include "light/transport/classic_light.h"
#include "light/transport/cone_mixture.h"
#include "light/transport/direct_light.h"
#include "light/transport/first_hit.h"
#include "light/transport/integrator.h"
#include "light/transport/non_finite.h"
#include "light/transport/path_state.h"
#include "light/transport/scattering_event.h"
#include "light/transport/surface_vertices.h"

namespace candela {

class PathWave {
public:
    /// Most paths a wave holds, and most vertices that one shader is asked about at once: the
    /// rays of a wave and the shading data of a chunk each fit a core's second-level cache.
    static constexpr int capacity = 4096, chunk = 1024;

    PathWave(const Scene &, const IntegratorSettings &, const PixelFilterSampler &,
             std::span<const ChannelInfo> channels, TransportStatistics &, NonFiniteReporter &);

    /// Camera paths for the samples [first, last) of `pixels` pixels (x[i], y[i]), pixel by pixel.
    void startCamera(int pixels, const int *x, const int *y, int first, int last);
    /// Follows all paths to their ends.
    void run();

    int slots() const { return slots_; }
    const PathResults &results() const { return results_; }

private:
    void traceAndShade(int iteration);
    void binByCode();
    void shadeChunk(int code, const int *order, int count, int iteration);
    void gatherState(const int *order, int count);
    void addEmission();
    void addVisible(const int *order);
    void lightClassic(const float *const *ambient);
    void lightPath();
    void stateMixture();
    void addToRadiance(const float *const *contribution);
    void scatterOn();
    void followEvents(const float *roulette);
    void append(int i, Vec3 direction, const Color &throughput, std::int32_t event, float pdf);

    const Scene &scene_;
    const IntegratorSettings &settings_;
    const PixelFilterSampler &filter_;
    std::vector<FirstHitPlane> firstHit_;
    TransportStatistics &statistics_;
    NonFiniteReporter &nonFinite_;

    PathResults results_;
    int slots_ = 0;
    ActivePaths active_, next_;
    HitBatch hits_;
    std::vector<int> order_, binStart_, binNext_;

    // One chunk of vertices.
    SurfaceVertices vertices_;
    ConeMixture mixture_;
    ScatteringEvents events_;
    DirectLight direct_;
    ClassicLight classic_;
    Planes<float> state_;        ///< throughput, then lastPdf, travelled.
    Planes<int> stateIntegers_;  ///< slot, depth, lightSet, seen.
    Planes<std::uint32_t> keys_; ///< pixel key, sample index.
    Planes<float> random_;       ///< pairs of uniform numbers
    Planes<float> answers_;      ///< contributions, g, ambient
    Planes<float> scratch_;      ///< directions and pdfs
};

} // namespace candela
