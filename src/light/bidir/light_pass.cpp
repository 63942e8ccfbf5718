// SPDX-License-Identifier: Apache-2.0
#include "light/bidir/light_pass.h"

#include "foundation/base/parallel.h"
#include "light/path/stages.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

/// Paths of a wave: half of what it holds, so that branches find room.
constexpr int pathsOfWave = PathWave::capacity / 2;
/// Vertices are kept of the first paths of a pass, as long as they take no more than this; drawing
/// from more of them gains nothing that can be measured.
constexpr std::int64_t mostKeptPaths = 1 << 17;

/// The light paths that belong to the samples before `sample`.
std::int64_t pathsBefore(const Scene &scene, const BidirectionalPlan &plan, int sample) {
    const auto [width, height] = scene.options().format.effectiveResolution();
    return std::int64_t(std::floor(plan.lightPaths * width * height * sample));
}

void bringSplats(LightWave &wave, int paths) {
    SplatBatch batch;
    batch.count = int(wave.image.x.size());
    batch.x = wave.image.x.data(), batch.y = wave.image.y.data();
    const float *values[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        values[c] = wave.image.splats[c].data();
    batch.values = values;
    batch.lightPaths = paths;
    wave.sink.add(batch);
}

void sortIntoCells(float radius, LightVertices &vertices) {
    std::vector<Vec3> places;
    places.reserve(vertices.rows.size());
    for (const LightVertex &vertex : vertices.rows)
        places.push_back(vertex.P);
    vertices.cells = MergeCells(places, radius);
    std::vector<LightVertex> sorted;
    sorted.reserve(vertices.rows.size());
    for (std::int32_t row : vertices.cells.order())
        sorted.push_back(vertices.rows[std::size_t(row)]);
    vertices.rows = std::move(sorted);
}

} // namespace

LightPass::LightPass(FrameContext &frame, const BidirectionalPlan &plan, SampleSink &sink)
    : frame_(frame), plan_(plan), counts_(plan.counts()), sink_(sink),
      waves_(std::max(1, threadCount())) {}

void LightPass::run(int first, int last, const std::function<bool()> &isStopped) {
    const std::int64_t begin = pathsBefore(frame_.scene, plan_, first);
    const std::int64_t end = pathsBefore(frame_.scene, plan_, last);
    const std::size_t waves = std::size_t((end - begin + pathsOfWave - 1) / pathsOfWave);
    const std::size_t keeping =
        std::min(waves, std::size_t((mostKeptPaths + pathsOfWave - 1) / pathsOfWave));
    vertices_.paths = std::min<std::int64_t>(end - begin, std::int64_t(keeping) * pathsOfWave);
    const float radius = plan_.merging.isUsed() ? plan_.merging.radiusAt(first) : 0;
    counts_.merging =
        plan_.merging.trust * std::numbers::pi * radius * radius * double(vertices_.paths);
    std::vector<std::vector<LightVertex>> kept(keeping);
    std::atomic<std::size_t> next{0};
    parallelFor(waves_.size(), [&](std::size_t thread) {
        if (!waves_[thread])
            waves_[thread] = std::make_unique<LightWave>(frame_, counts_, sink_);
        LightWave &wave = *waves_[thread];
        wave.subpaths->counts = counts_;
        for (std::size_t at; !isStopped() && (at = next++) < waves;) {
            const std::int64_t from = begin + std::int64_t(at) * pathsOfWave;
            const int count = int(std::min<std::int64_t>(pathsOfWave, end - from));
            wave.keeps = at < keeping;
            startLight(wave, from, count);
            follow(wave);
            if (wave.keeps)
                kept[at] = std::move(wave.kept);
            bringSplats(wave, count);
        }
    });
    vertices_.rows.clear();
    for (const std::vector<LightVertex> &rows : kept)
        vertices_.rows.insert(vertices_.rows.end(), rows.begin(), rows.end());
    if (radius > 0)
        sortIntoCells(radius, vertices_);
}

} // namespace candela
