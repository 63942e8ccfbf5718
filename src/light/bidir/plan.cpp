// SPDX-License-Identifier: Apache-2.0
#include "light/bidir/plan.h"

#include "light/bidir/light_wave.h"
#include "light/path/stages.h"

namespace candela {

namespace {

/// Takes splats and forgets them.
class NoPicture : public SampleSink {
public:
    std::span<const ChannelInfo> channels() const override { return {}; }
    void add(const SampleBatch &) override {}
    void add(const SplatBatch &) override {}
};

/// Vertices to connect with, a light path; of the first ones of another seed.
double verticesPerPath(FrameContext &frame) {
    constexpr int paths = 4096;
    NoPicture sink;
    LightWave wave(frame, {0, 1}, sink);
    startLight(wave, 0, paths);
    follow(wave);
    return double(wave.kept.size()) / paths;
}

} // namespace

BidirectionalPlan planTechniques(FrameContext &frame) {
    BidirectionalPlan plan;
    if (!frame.scene.lights().startPaths() || frame.scene.hasVolumes())
        return plan;
    plan.verticesPerPath = verticesPerPath(frame);
    if (!(plan.verticesPerPath > 0))
        return plan;
    plan.lightPaths = 1;
    plan.connections = 1;
    return plan;
}

} // namespace candela
