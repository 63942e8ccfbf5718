// SPDX-License-Identifier: Apache-2.0
#include "light/path/wave.h"

#include "foundation/base/lanes.h"
#include "light/path/numbers.h"
#include "light/path/solution_light.h"
#include "light/path/stages.h"

namespace candela {

FrameContext::FrameContext(const Scene &scene, const IntegratorSettings &settings,
                           const PixelFilterSampler &filter, std::span<const ChannelInfo> channels,
                           TransportStatistics &statistics, DiagnosticSink &diagnostics,
                           const EmissionGuide *guide)
    : scene(scene), settings(settings), filter(filter), firstHit(firstHitPlanes(channels)),
      shaderChannels(scene, channels), statistics(statistics), nonFinite(statistics, diagnostics),
      diagnostics(diagnostics), guide(guide) {}

PathWave::PathWave(FrameContext &frame, Purpose purpose)
    : PathWave(frame, purpose, stagesOfIntegrator, false) {}

PathWave::PathWave(FrameContext &frame, Purpose purpose, StageList stages,
                   const TechniqueCounts &counts)
    : PathWave(frame, purpose, stages, true) {
    subpaths = std::make_unique<Subpaths>(VertexChunk::capacity, counts);
    chunk.direct.sample.tellPlaces();
}

PathWave::PathWave(FrameContext &frame, Purpose purpose, StageList stages, bool hasTwoEnds)
    : frame(frame), purpose(purpose), stages(stages),
      results(capacity, purpose == Purpose::Camera ? int(frame.firstHit.size()) : 0),
      active(capacity, frame.scene.hasVolumes(), hasTwoEnds),
      next(capacity, frame.scene.hasVolumes(), hasTwoEnds), hits(capacity),
      bins(frame.scene, capacity), cameraNumbers(2 * cameraPairs, capacity), shares(capacity) {
    if (frame.solution)
        solution = std::make_unique<SolutionLight>(VertexChunk::capacity);
}

PathWave::~PathWave() = default;

VertexChunk::VertexChunk()
    : vertices(capacity), paths(capacity), numbers(capacity), ambientLight(colorSamples, capacity),
      events(capacity), mixture(capacity), normals(3, capacity), hemisphere(capacity),
      emission(capacity), direct(capacity), way(capacity) {
    for (int c = 0; c < colorSamples; ++c)
        ambientTable[c] = ambientLight[c];
}

void VertexChunk::gather(const std::array<const float *, colorSamples> &contribution) {
    for (int c = 0; c < colorSamples; ++c)
        lanes::multiplyAdd(count(), paths.throughput[c], contribution[c], paths.light[c]);
}

} // namespace candela
