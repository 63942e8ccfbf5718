// SPDX-License-Identifier: Apache-2.0
// The frame as passes, passes as tiles, a tile of a pass as a wave, or as several where pixels
// differ in their numbers of samples.
#include "light/frame/integrate.h"
#include "foundation/base/parallel.h"
#include "light/bidir/light_pass.h"
#include "light/bidir/plan.h"
#include "light/frame/adaptive_sampling.h"
#include "light/path/solve.h"
#include "light/path/split.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <vector>

namespace candela {

namespace {

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
    AdaptiveSampling::Pixels pixels;
};

/// Tiles so large that the branches of a pass over a tile's pixels fill a wave, and no larger.
int tileSize(int samples) {
    int size = 64;
    while (size > 1 && size * size * samples * cameraDirections > PathWave::capacity)
        size /= 2;
    return size;
}

/// Lets samples by; splats as the frame's progress has it, and none that have come before.
class SplatGate : public SampleSink {
public:
    SplatGate(SampleSink &sink, FrameProgress &progress) : sink_(sink), progress_(progress) {}

    std::span<const ChannelInfo> channels() const override { return sink_.channels(); }
    void add(const SampleBatch &batch) override { sink_.add(batch); }
    void add(const SplatBatch &batch) override {
        if (!progress_.hasLightPaths())
            progress_.bring([&] { sink_.add(batch); });
    }

private:
    SampleSink &sink_;
    FrameProgress &progress_;
};

/// A frame's passes, with all that is made for them once.
class FramePasses {
public:
    FramePasses(FrameContext &frame, const BidirectionalPlan &plan, SampleSink &sink,
                FrameProgress &progress)
        : frame_(frame), plan_(plan), sink_(sink), progress_(progress), gate_(sink, progress),
          adaptive_(frame.settings), workers_(std::size_t(std::max(1, threadCount()))) {
        if (plan.lightPaths > 0)
            lightPaths_ = std::make_unique<LightPass>(frame, plan, gate_);
    }

    void run() {
        progress_.makeRoomForWishes(adaptive_.wishes());
        const int end = frame_.settings.lastSample;
        for (int first = progress_.firstSample(), last; first < end; first = last) {
            last = std::min(endOfPass(first), end);
            run(first, last);
            if (progress_.isStopped())
                return;
        }
        progress_.beginPass(end, 0);
    }

private:
    /// Passes that merge paths are made of rounds.
    int endOfPass(int first) const {
        const int last = adaptive_.isOn() ? adaptive_.passEnd(first) : passEnd(first);
        return plan_.merging.isUsed() ? std::min(plan_.merging.roundEnd(first), last) : last;
    }

    /// A wave each.
    std::vector<TilePart> partsOf(int first, int last) const {
        if (adaptive_.isOn())
            return adaptive_.parts(first, last, progress_.wishes());
        std::vector<TilePart> parts;
        for (const Tile &tile : tilesOver(frame_.settings.crop, tileSize(last - first)))
            parts.push_back({tile, 0, tile.size * tile.size});
        return parts;
    }

    void render(Worker &worker, const TilePart &part, int first, int last) const {
        auto &[x, y, halves] = worker.pixels;
        if (adaptive_.isOn())
            adaptive_.pixelsOf(part, first, progress_.wishes(), worker.pixels);
        else
            pixelsOf(part.tile, x, y);
        startCamera(*worker.wave, {int(x.size()), x.data(), y.data(), first, last,
                                   adaptive_.isOn() ? halves.data() : nullptr});
        follow(*worker.wave);
    }

    void bring(const Worker &worker, const TilePart &part, int first) {
        bringSamples(*worker.wave, sink_);
        if (adaptive_.isOn() && adaptive_.isPilot(first))
            adaptive_.decide(part, worker.wave->results, progress_.wishes());
    }

    void run(int first, int last) {
        const std::vector<TilePart> parts = partsOf(first, last);
        progress_.beginPass(first, parts.size());
        if (lightPaths_ && !followLightPaths(first, last))
            return;
        std::atomic<std::size_t> next{0}, done{0};
        parallelFor(workers_.size(), [&](std::size_t thread) {
            Worker &worker = workerOf(thread);
            for (std::size_t at; !progress_.isStopped() && (at = next++) < parts.size();) {
                if (!progress_.isTaken(at)) {
                    render(worker, parts[at], first, last);
                    progress_.bringTile(at, [&] { bring(worker, parts[at], first); });
                }
                report(first + double(++done) / double(parts.size()) * (last - first));
            }
        });
    }

    /// False if the pass is stopped amid them. Those whose light has come are followed again, since
    /// camera paths are connected with them.
    bool followLightPaths(int first, int last) {
        const bool haveCome = progress_.hasLightPaths();
        if (!haveCome)
            progress_.beginLightPaths();
        lightPaths_->run(first, last, [&] { return progress_.isStopped(); });
        if (progress_.isStopped())
            return false;
        if (!haveCome)
            progress_.endLightPaths();
        return true;
    }

    Worker &workerOf(std::size_t thread) {
        std::unique_ptr<Worker> &worker = workers_[thread];
        if (!worker)
            worker = std::make_unique<Worker>(makeWave());
        if (worker->wave->subpaths)
            worker->wave->subpaths->counts = lightPaths_->counts();
        return *worker;
    }

    std::unique_ptr<PathWave> makeWave() {
        if (!lightPaths_ || plan_.besidePath)
            return std::make_unique<PathWave>(frame_);
        return std::make_unique<EyeWave>(frame_, plan_.counts(), lightPaths_->vertices(),
                                         plan_.connections);
    }

    void report(double samples) const {
        if (frame_.settings.progress)
            frame_.settings.progress(samples / frame_.settings.lastSample);
    }

    FrameContext &frame_;
    const BidirectionalPlan &plan_;
    SampleSink &sink_;
    FrameProgress &progress_;
    SplatGate gate_;
    std::unique_ptr<LightPass> lightPaths_;
    const AdaptiveSampling adaptive_;
    std::vector<std::unique_ptr<Worker>> workers_; ///< One a thread.
};

} // namespace

void integrate(const Scene &scene, const IntegratorSettings &settings,
               const PixelFilterSampler &filter, SampleSink &sink, FrameProgress &progress,
               TransportStatistics &statistics, DiagnosticSink &diagnostics) {
    IntegratorSettings taken = settings;
    FrameContext frame(scene, taken, filter, sink.channels(), statistics, diagnostics);
    BidirectionalPlan plan;
    EmissionGuide guide;
    if (settings.kind == IntegratorKind::Bidirectional)
        plan = planTechniques(frame, guide);
    frame.guide = &guide;
    if (settings.kind == IntegratorKind::Bidirectional &&
        (plan.besidePath || !(plan.lightPaths > 0)))
        taken.kind = IntegratorKind::Path;
    const std::unique_ptr<radiosity::Solution> solution =
        solve(scene, settings, statistics, diagnostics);
    frame.solution = solution.get();
    FramePasses(frame, plan, sink, progress).run();
}

} // namespace candela
