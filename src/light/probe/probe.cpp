// SPDX-License-Identifier: Apache-2.0
#include "light/probe/probe.h"

#include "foundation/base/parallel.h"
#include "light/bidir/eye_wave.h"
#include "light/path/solve.h"
#include "light/probe/light_sets.h"
#include "light/probe/placed_points.h"
#include "light/probe/sensors.h"
#include "light/probe/solved_points.h"
#include "light/sampling/sobol.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

namespace candela {

namespace {

constexpr int batches = PointEstimate::batches;

/// What all threads share.
struct Shared {
    Shared(const Scene &scene, const ProbeSettings &settings, TransportStatistics &statistics,
           DiagnosticSink &diagnostics)
        : scene(scene), settings(settings), rule(settings.samples, settings.accuracy),
          integrator(settings.integrator), filter(scene.options().filter, diagnostics),
          frame(scene, integrator, filter, channels, statistics, diagnostics),
          solution(solve(scene, integrator, statistics, diagnostics)) {
        integrator.atPoints = true;
        frame.solution = solution.get();
        if (scene.isBidirectional())
            lightSets.emplace(frame, batches);
        if (!hasLightPaths() && scene.isBidirectional())
            integrator.kind = IntegratorKind::Path;
    }
    bool hasLightPaths() const { return lightSets && !lightSets->isEmpty(); }
    /// The solution tells what sensors on its surfaces take, but for a bounce of their own.
    bool isToldBySolution() const {
        return solution && settings.quantity == ProbeQuantity::Irradiance &&
               integrator.finalPass != FinalPass::Gather;
    }
    bool samplesSources() const { return integrator.finalPass == FinalPass::Direct; }

    const Scene &scene;
    const ProbeSettings settings;
    const StoppingRule rule;
    IntegratorSettings integrator;
    /// What frames have, and points make no use of.
    PixelFilterSampler filter;
    const std::array<ChannelInfo, 2> channels{{{"Ci", colorSamples}, {"Oi", colorSamples}}};
    FrameContext frame;
    std::unique_ptr<radiosity::Solution> solution;
    std::optional<LightSets> lightSets;
};

std::unique_ptr<PathWave> makeWave(Shared &shared) {
    if (!shared.hasLightPaths())
        return std::make_unique<PathWave>(shared.frame);
    const LightSets &sets = *shared.lightSets;
    return std::make_unique<EyeWave>(shared.frame, sets.counts(), sets[0], LightSets::connections);
}

/// One thread's part: blocks of points, one after the other.
class Worker {
public:
    explicit Worker(Shared &shared)
        : shared_(shared), wave_(makeWave(shared)), sphere_(sphereRays) {
        if (shared.isToldBySolution())
            solved_.emplace(shared.scene, *shared.solution, !shared.samplesSources(),
                            Prober::blockSize);
    }

    void answer(std::span<const ProbePoint> points, std::span<ProbeAnswer> answers) {
        placed_.clear(), active_.clear();
        estimates_.assign(points.size(), {});
        known_.assign(points.size(), Color{});
        for (const ProbePoint &point : points)
            placed_.push_back(place(point, shared_.scene, shared_.settings));
        if (solved_)
            answerSolved(answers);
        for (int k = 0; k < int(points.size()); ++k)
            if (!solved_ || !solved_->at(k))
                active_.push_back(k);
        sample(SensorTakes::All, answers);
    }

private:
    /// Of those that lie on surfaces: what the solution tells, and samples the rest.
    void answerSolved(std::span<ProbeAnswer> answers) {
        solved_->lookUp(placed_);
        for (int k = 0; k < int(placed_.size()); ++k)
            if (const auto &irradiance = solved_->at(k)) {
                known_[std::size_t(k)] = *irradiance;
                active_.push_back(k);
            }
        if (shared_.samplesSources())
            return sample(SensorTakes::Sources, answers);
        addAmbientLight(answers);
    }

    /// All that is missing of the active points.
    void addAmbientLight(std::span<ProbeAnswer> answers) {
        takes_ = SensorTakes::Ambient;
        slots_.count = 0;
        for (int k : active_)
            fill(slots_.count++, placed_[std::size_t(k)], 0, 0);
        measure();
        for (int slot = 0; slot < slots_.count; ++slot) {
            const std::size_t point = std::size_t(active_[std::size_t(slot)]);
            const Color irradiance = sampleOf(point, slot);
            ProbeAnswer &answer = answers[point];
            for (int c = 0; c < colorSamples; ++c)
                answer.value[std::size_t(c)] = double(irradiance[c]);
            answer.photometric = double(luminousEfficacy * luminance(irradiance));
        }
        toCheck_.swap(active_);
        findEnclosed(answers);
    }

    /// All that is to be answered of the active points.
    void sample(SensorTakes takes, std::span<ProbeAnswer> answers) {
        takes_ = takes;
        for (int look = 0, from = 0; !active_.empty(); ++look) {
            const int to = shared_.rule.samplesAt(look);
            takeSamples(from, to);
            finishPoints(look, answers);
            from = to;
        }
    }

    /// Samples [from, to) of each batch of each active point.
    void takeSamples(int from, int to) {
        // Where batches have light paths of their own, they do not share waves.
        const int together = shared_.hasLightPaths() ? 1 : batches;
        for (int batch = 0; batch < batches; batch += together) {
            if (shared_.hasLightPaths())
                static_cast<EyeWave &>(*wave_).lightVertices = &(*shared_.lightSets)[batch];
            takeBatches(batch, together, from, to);
        }
        for (int point : active_)
            estimates_[std::size_t(point)].setSamples(to);
    }

    void takeBatches(int firstBatch, int together, int from, int to) {
        const std::int64_t each = std::int64_t(together) * (to - from);
        const std::int64_t all = each * std::int64_t(active_.size());
        const auto pointAt = [&](std::int64_t at) {
            return std::size_t(active_[std::size_t(at / each)]);
        };
        const auto batchAt = [&](std::int64_t at) {
            return firstBatch + int(at % each / (to - from));
        };
        for (std::int64_t first = 0; first < all; first += ProbeSlots::capacity) {
            slots_.count = int(std::min<std::int64_t>(ProbeSlots::capacity, all - first));
            for (int slot = 0; slot < slots_.count; ++slot) {
                const std::int64_t at = first + slot;
                fill(slot, placed_[pointAt(at)], batchAt(at), from + int(at % (to - from)));
            }
            measure();
            for (int slot = 0; slot < slots_.count; ++slot)
                add(pointAt(first + slot), batchAt(first + slot), slot);
        }
    }

    void fill(int slot, const PlacedPoint &point, int batch, int sample) {
        for (int c = 0; c < 3; ++c) {
            slots_.Ps[c][slot] = point.P[c], slots_.origin[c][slot] = point.origin[c];
            slots_.aim[c][slot] = point.aim[c];
        }
        slots_.time[slot] = shared_.scene.options().camera.shutterOpen;
        slots_.point[slot] = point.number;
        slots_.pixelKey[slot] = pixelKey(point.number, batch, shared_.integrator.seed);
        slots_.sampleIndex[slot] = std::uint32_t(sample);
    }

    void measure() {
        if (shared_.settings.quantity == ProbeQuantity::Irradiance)
            measureIrradiance(*wave_, slots_, light_, rays_, takes_);
        else
            measureRadiance(*wave_, slots_, rays_);
    }

    void add(std::size_t point, int batch, int slot) {
        estimates_[point].add(batch, sampleOf(point, slot));
    }

    /// What has been measured at the slot, and what is known of its point.
    Color sampleOf(std::size_t point, int slot) const {
        Color value = valueOf(slot);
        for (int c = 0; c < colorSamples; ++c)
            value[c] += known_[point][c];
        return value;
    }

    Color valueOf(int slot) const {
        Color value;
        for (int c = 0; c < colorSamples; ++c)
            value[c] = slots_.value[c][slot];
        return value;
    }

    /// Writes the answers of those that have been looked at enough.
    void finishPoints(int look, std::span<ProbeAnswer> answers) {
        const bool last = shared_.rule.isLast(look);
        std::erase_if(active_, [&](int point) {
            const PointEstimate &estimate = estimates_[std::size_t(point)];
            const bool suffices = shared_.rule.suffices(estimate, look);
            if (!suffices && !last)
                return false;
            ProbeAnswer &answer = answers[std::size_t(point)];
            answer.value = estimate.mean();
            answer.photometric = double(luminousEfficacy) * estimate.luminance();
            answer.halfWidth = double(luminousEfficacy) * shared_.rule.halfWidth(estimate, look);
            answer.samples = estimate.samples();
            answer.reached = suffices || !shared_.settings.accuracy;
            toCheck_.push_back(point);
            return true;
        });
        findEnclosed(answers);
    }

    void findEnclosed(std::span<ProbeAnswer> answers) {
        for (int point : toCheck_)
            answers[std::size_t(point)].enclosed = answers[std::size_t(point)].photometric == 0 &&
                                                   isEnclosed(placed_[std::size_t(point)]);
        toCheck_.clear();
    }

    /// Whatever can be seen from the point is dark, and nothing is open.
    bool isEnclosed(const PlacedPoint &point) {
        if (shared_.settings.quantity != ProbeQuantity::Irradiance || shared_.scene.isClassic())
            return false;
        lookAround(point);
        const HitBatch &hits = sphere_.hits;
        if (std::find(hits.shape, hits.shape + sphereRays, noHit) != hits.shape + sphereRays)
            return false;
        constexpr float before = 1 - 1e-4f; // Just off what has been met,
        const RayBatch &rays = sphere_.rays;
        slots_.count = sphereRays;
        for (int slot = 0; slot < sphereRays; ++slot) {
            PlacedPoint met = point;
            for (int c = 0; c < 3; ++c) {
                met.origin[c] += before * hits.t[slot] * rays.direction[c][slot];
                met.aim[c] = -rays.direction[c][slot]; // facing back.
            }
            met.P = met.origin;
            fill(slot, met, 0, slot);
        }
        measureIrradiance(*wave_, slots_, light_, rays_);
        for (int slot = 0; slot < sphereRays; ++slot)
            if (luminance(valueOf(slot)) != 0)
                return false;
        return true;
    }

    /// Rays in all directions alike.
    void lookAround(const PlacedPoint &point) {
        RayBatch &rays = sphere_.rays;
        rays.count = sphereRays;
        for (int ray = 0; ray < sphereRays; ++ray) {
            const float z = 1 - (2 * float(ray) + 1) / sphereRays, r = std::sqrt(1 - z * z);
            const float turn = float(ray) * std::numbers::phi_v<float> * 2 * float(M_PI);
            for (int c = 0; c < 3; ++c)
                rays.origin[c][ray] = point.origin[c];
            rays.direction[0][ray] = r * std::cos(turn);
            rays.direction[1][ray] = r * std::sin(turn);
            rays.direction[2][ray] = z;
            rays.tMax[ray] = INFINITY;
        }
        shared_.scene.intersect(rays, sphere_.hits, Coherence::Secondary);
    }

    static constexpr int sphereRays = 64;
    struct SphereRays {
        explicit SphereRays(int count) : rays(count), hits(count) {}
        RayBatch rays;
        HitBatch hits;
    };

    Shared &shared_;
    std::unique_ptr<PathWave> wave_;
    ProbeSlots slots_;
    SensorLight light_;
    ProbeRays rays_;
    SphereRays sphere_;
    std::vector<PlacedPoint> placed_;
    std::optional<SolvedPoints> solved_;
    SensorTakes takes_ = SensorTakes::All;
    std::vector<PointEstimate> estimates_;
    std::vector<Color> known_;          ///< Of the points, without samples.
    std::vector<int> active_, toCheck_; ///< Points under way; those that have just ended.
};

} // namespace

struct Prober::State : Shared {
    using Shared::Shared;
    std::vector<std::unique_ptr<Worker>> workers{std::size_t(std::max(1, threadCount()))};
};

Prober::Prober(const Scene &scene, const ProbeSettings &settings, TransportStatistics &statistics,
               DiagnosticSink &diagnostics)
    : state_(std::make_unique<State>(scene, settings, statistics, diagnostics)) {}

Prober::~Prober() = default;

void Prober::answer(std::span<const ProbePoint> points, std::span<ProbeAnswer> answers) {
    const std::size_t blocks = (points.size() + blockSize - 1) / blockSize;
    std::atomic<std::size_t> next{0};
    parallelFor(std::min(blocks, state_->workers.size()), [&](std::size_t thread) {
        std::unique_ptr<Worker> &worker = state_->workers[thread];
        for (std::size_t block; (block = next++) < blocks;) {
            if (!worker)
                worker = std::make_unique<Worker>(*state_);
            const std::size_t first = block * blockSize;
            const std::size_t count = std::min<std::size_t>(blockSize, points.size() - first);
            worker->answer(points.subspan(first, count), answers.subspan(first, count));
        }
    });
}

} // namespace candela
