// SPDX-License-Identifier: Apache-2.0
// The frame as passes, passes as tiles, a tile of a pass as a wave. Tiles are squares aligned to
// absolute pixels and traced whole even where the crop window cuts them, so that ray packets, and
// with them the picture, do not depend on the crop.
#include "light/frame/integrate.h"
#include "foundation/base/parallel.h"
#include "light/bidir/light_pass.h"
#include "light/bidir/plan.h"
#include "light/path/split.h"
#include "light/path/stages.h"
#include "light/radiosity/solution.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <vector>

namespace candela {

namespace {

struct Tile {
    int x, y, size;
};

int roundDown(int value, int step) { return value - ((value % step) + step) % step; }

/// Tiles so large that the branches of a pass over a tile's pixels fill a wave, and no larger.
int tileSize(int samples) {
    int size = 64;
    while (size > 1 && size * size * samples * cameraDirections > PathWave::capacity)
        size /= 2;
    return size;
}

std::vector<Tile> tilesOver(const std::array<int, 4> &crop, int size) {
    std::vector<Tile> tiles;
    for (int y = roundDown(crop[2], size); y < crop[3]; y += size)
        for (int x = roundDown(crop[0], size); x < crop[1]; x += size)
            tiles.push_back({x, y, size});
    return tiles;
}

/// The tile's pixels in Morton order: neighbours in the wave are neighbours in the picture.
void pixelsOf(const Tile &tile, std::vector<int> &x, std::vector<int> &y) {
    x.clear();
    y.clear();
    for (int code = 0; code < tile.size * tile.size; ++code) {
        int dx = 0, dy = 0;
        for (int bit = 0; bit < 8; ++bit) {
            dx |= ((code >> (2 * bit)) & 1) << bit;
            dy |= ((code >> (2 * bit + 1)) & 1) << bit;
        }
        x.push_back(tile.x + dx);
        y.push_back(tile.y + dy);
    }
}

void bringSamples(const PathWave &wave, SampleSink &sink) {
    const PathResults &results = wave.results;
    std::vector<const float *> values;
    for (int c = 0; c < colorSamples; ++c)
        values.push_back(results.radiance[c]);
    for (int c = 0; c < colorSamples; ++c)
        values.push_back(results.opacity[c]);
    for (int plane = 0; plane < results.channels.planes(); ++plane)
        values.push_back(results.channels[plane]);
    sink.add(
        {wave.slots, results.x, results.y, results.sampleIndex, results.weight[0], values.data()});
}

/// The waves and pixel lists of one thread, kept from pass to pass.
struct Worker {
    explicit Worker(std::unique_ptr<PathWave> wave) : wave(std::move(wave)) {}
    std::unique_ptr<PathWave> wave;
    std::vector<int> x, y;
};

/// Passes that merge paths are made of rounds.
int partEnd(const BidirectionalPlan &plan, int first) {
    const int last = passEnd(first);
    return plan.merging.isUsed() ? std::min(plan.merging.roundEnd(first), last) : last;
}

void renderTile(Worker &worker, const Tile &tile, int first, int last, SampleSink &sink) {
    pixelsOf(tile, worker.x, worker.y);
    startCamera(*worker.wave, int(worker.x.size()), worker.x.data(), worker.y.data(), first, last);
    follow(*worker.wave);
    bringSamples(*worker.wave, sink);
}

} // namespace

void integrate(const Scene &scene, const IntegratorSettings &settings,
               const PixelFilterSampler &filter, SampleSink &sink, TransportStatistics &statistics,
               DiagnosticSink &diagnostics) {
    IntegratorSettings taken = settings;
    FrameContext frame(scene, taken, filter, sink.channels(), statistics, diagnostics);
    BidirectionalPlan plan;
    EmissionGuide guide;
    if (settings.kind == IntegratorKind::Bidirectional)
        plan = planTechniques(frame, guide);
    frame.guide = &guide;
    if (settings.kind == IntegratorKind::Bidirectional && !(plan.lightPaths > 0))
        taken.kind = IntegratorKind::Path;
    std::unique_ptr<radiosity::Solution> solution;
    if (settings.kind == IntegratorKind::Radiosity) {
        solution = std::make_unique<radiosity::Solution>(scene, settings.solver, diagnostics,
                                                         settings.solving);
        statistics.solver = solution->statistics();
        frame.solution = solution.get();
    }
    std::unique_ptr<LightPass> lightPaths;
    if (plan.lightPaths > 0)
        lightPaths = std::make_unique<LightPass>(frame, plan, sink);
    const auto makeWave = [&]() -> std::unique_ptr<PathWave> {
        if (!lightPaths)
            return std::make_unique<PathWave>(frame);
        return std::make_unique<EyeWave>(frame, plan.counts(), lightPaths->vertices(),
                                         plan.connections);
    };
    std::vector<std::unique_ptr<Worker>> workers(std::max(1, threadCount()));
    const double samples = settings.lastSample - settings.firstSample;
    for (int first = settings.firstSample, last; first < settings.lastSample; first = last) {
        last = std::min(partEnd(plan, first), settings.lastSample);
        const std::vector<Tile> tiles = tilesOver(settings.crop, tileSize(last - first));
        std::atomic<std::size_t> next{0}, done{0};
        if (lightPaths)
            lightPaths->run(first, last);
        parallelFor(workers.size(), [&](std::size_t thread) {
            if (!workers[thread])
                workers[thread] = std::make_unique<Worker>(makeWave());
            if (lightPaths)
                workers[thread]->wave->subpaths->counts = lightPaths->counts();
            for (std::size_t at; (at = next++) < tiles.size();) {
                renderTile(*workers[thread], tiles[at], first, last, sink);
                const double share = double(++done) / double(tiles.size());
                if (settings.progress)
                    settings.progress((first - settings.firstSample + share * (last - first)) /
                                      samples);
            }
        });
    }
}

} // namespace candela
