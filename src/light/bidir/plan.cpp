// SPDX-License-Identifier: Apache-2.0
#include "light/bidir/plan.h"

#include "light/bidir/eye_wave.h"
#include "light/bidir/learn_emission.h"
#include "light/bidir/light_wave.h"
#include "light/bidir/no_picture.h"
#include "light/path/stages.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace candela {

namespace {

/// What a pilot asks about: no light paths at all, and three plans with them.
constexpr BidirectionalPlan candidates[] = {{0, 0}, {0.25, 0}, {1, 0}, {1, 1}};

/// Of a pilot: samples of a pixel, and pixels; small frames have smaller ones. How many samples the
/// frame takes has no say: a picture may be continued.
constexpr int samplesOfPixel = 4, mostPixels = 4096, leastPixels = 512, pilotShare = 16;
/// Samples that are so much brighter than their surroundings are taken for rare: a pilot of `path`
/// may have missed them.
constexpr double rareLight = 8;
constexpr float tinyWidth = 1e-3f;
constexpr int lightPathsOfPilot = 4096;
/// Of learning where light paths begin best: for the pilots, and for the frame, if it has such
/// paths.
constexpr int roundsOfPilot = 3, roundsOfFrame = 64;
/// A ray of a light path costs more than one of a camera path, with the connection to the lens; and
/// a connection of each vertex, as a share of all that a camera path costs. Measured on rooms of
/// matte and plastic walls.
constexpr double costOfLightRay = 1.6, costOfConnections = 1.4;
/// Pictures are judged by the luminance's error over its mean, and over the place's own with this
/// share of the mean besides.
constexpr double floorOfLuminance = 0.1;

/// Few samples a pixel do not show how much more evenly many of them lie; those of light paths do
/// not lie evenly in pixels. So `path` is left only for what promises to be this much better.
constexpr double worthLeavingPath = 0.5;

/// A round of merging has as many light paths as fill a picture of this many pixels, if there is
/// one path a pixel; small frames put some samples of a pixel together.
constexpr double pathsOfRound = 1 << 16;
constexpr int mostSamplesOfRound = 16;
/// Discs that are merged over are at first so many pixels wide.
constexpr float widthInPixels = 6;

class NoMessages : public DiagnosticSink {
public:
    void report(const Diagnostic &) override {}
};

/// A plan's error and cost, of one sample a pixel.
struct Trial {
    std::vector<double> variance; ///< Of the luminance, by cell.
    std::vector<double> mean;
    double cost = 0;
};

class Pilot {
public:
    explicit Pilot(FrameContext &frame)
        : frame_(frame), settings_(frame.settings), window_(wholeFrame(frame.scene)),
          middle_({"box", tinyWidth, tinyWidth}, silence_) {
        settings_.seed = frame.settings.seed * 0x9e3779b9u + 0x7f4a7c15u; // Other samples.
        const double pixels = double(window_[1] - window_[0]) * (window_[3] - window_[2]);
        const int wanted = int(pixels / pilotShare);
        choosePixels(std::clamp(wanted, leastPixels, mostPixels), pixels);
    }

    /// Vertices to connect with, a light path.
    double verticesPerPath() {
        settings_.kind = IntegratorKind::Bidirectional;
        TransportStatistics statistics;
        FrameContext frame = pilotFrame(statistics, frame_.filter);
        NoPicture nothing;
        LightWave wave(frame, {0, 1}, nothing);
        startLight(wave, 0, lightPathsOfPilot);
        follow(wave);
        return double(wave.kept.size()) / lightPathsOfPilot;
    }

    /// After the pilot of `path`.
    EmissionGuide learn(int rounds) {
        settings_.kind = IntegratorKind::Bidirectional;
        TransportStatistics statistics;
        FrameContext frame = pilotFrame(statistics, frame_.filter);
        guide_ = learnEmission(frame, meanOfPath_, x_, y_, rounds);
        return *guide_;
    }

    /// How vertices are merged where there are so many light paths a sample of a pixel.
    MergingPlan planMerging(double lightPaths) {
        const BidirectionalWishes &wishes = settings_.bidirectional;
        MergingPlan plan;
        plan.trust = wishes.trustInMerging;
        plan.radius = wishes.radius.value_or(widthInPixels / 2 * widthOfPixels());
        const double pixels = double(window_[1] - window_[0]) * (window_[3] - window_[2]);
        plan.samplesOfRound = 1;
        while (plan.samplesOfRound < mostSamplesOfRound &&
               lightPaths * pixels * plan.samplesOfRound < pathsOfRound)
            plan.samplesOfRound *= 2;
        return plan;
    }

    Trial run(const BidirectionalPlan &plan) {
        const bool fromLights = plan.lightPaths > 0;
        settings_.kind = fromLights ? IntegratorKind::Bidirectional : IntegratorKind::Path;
        TransportStatistics statistics;
        FrameContext frame = pilotFrame(statistics, middle_);
        Trial trial;
        trial.variance.assign(cells, 0), trial.mean.assign(cells, 0);
        LightVertices vertices;
        if (fromLights)
            followLight(plan, statistics, vertices, trial);
        const double lightCost = trial.cost;
        trial.cost = 0;
        const std::uint64_t before = statistics.bounceRays + statistics.shadowRays;
        if (fromLights) {
            EyeWave wave(frame, plan.counts(), vertices, plan.connections);
            followCamera(wave, trial);
        } else {
            PathWave wave(frame);
            followCamera(wave, trial);
            setMeanOfPath(trial);
        }
        const std::uint64_t rays =
            statistics.cameraRays + statistics.bounceRays + statistics.shadowRays - before;
        trial.cost = double(rays) / (double(x_.size()) * samplesOfPixel) *
                         (1 + costOfConnections * plan.connections) +
                     lightCost;
        return trial;
    }

    /// By cell, what `path` would at least make of the light that light paths have found.
    const std::vector<double> &varianceOfPath() const { return varianceOfPath_; }

private:
    static constexpr int cells = LightTally::cells * LightTally::cells;

    FrameContext pilotFrame(TransportStatistics &statistics, const PixelFilterSampler &filter) {
        return FrameContext(frame_.scene, settings_, filter, light_, statistics, silence_,
                            guide_ ? &*guide_ : nullptr);
    }

    /// Spread over the frame (Roberts' sequence).
    void choosePixels(int count, double pixels) {
        count = int(std::min<double>(count, pixels));
        for (int k = 0; k < count; ++k) {
            const double u = std::fmod(0.5 + (k + 1) * 0.7548776662466927, 1.0);
            const double v = std::fmod(0.5 + (k + 1) * 0.5698402909980532, 1.0);
            x_.push_back(window_[0] + int(u * (window_[1] - window_[0])));
            y_.push_back(window_[2] + int(v * (window_[3] - window_[2])));
        }
    }

    /// At what the camera sees, the median, metres; 0 if it sees nothing.
    float widthOfPixels() {
        TransportStatistics statistics;
        FrameContext frame = pilotFrame(statistics, middle_);
        PathWave wave(frame);
        const int count = std::min(PathWave::capacity, int(x_.size()));
        startCamera(wave, {count, x_.data(), y_.data(), 0, 1});
        trace(wave);
        std::vector<float> widths;
        for (int i = 0; i < count; ++i)
            if (wave.hits.shape[i] != noHit)
                widths.push_back(frame.scene.camera().pixelSize(
                    wave.active.rays.origin[2][i] +
                    wave.hits.t[i] * wave.active.rays.direction[2][i]));
        if (widths.empty())
            return 0;
        const auto middle = widths.begin() + std::ptrdiff_t(widths.size() / 2);
        std::ranges::nth_element(widths, middle);
        return *middle;
    }

    void followLight(const BidirectionalPlan &plan, TransportStatistics &statistics,
                     LightVertices &vertices, Trial &trial) {
        FrameContext frame = pilotFrame(statistics, frame_.filter);
        NoPicture nothing;
        const auto [width, height] = frame.scene.options().format.effectiveResolution();
        LightTally tally(window_, plan.lightPaths * width * height);
        for (int cell = 0; cell < cells; ++cell)
            tally.values[cell].seldom = findsLight_ ? rareLight * meanOfPath_[cell] : 0;
        LightWave wave(frame, plan.counts(), nothing);
        wave.tally = &tally;
        startLight(wave, 0, lightPathsOfPilot);
        follow(wave);
        vertices.rows = std::move(wave.kept);
        vertices.paths = lightPathsOfPilot;
        const double inCell = double(window_[1] - window_[0]) * (window_[3] - window_[2]) / cells;
        const double ofMean = lightPathsOfPilot * inCell;
        const double ofSquares = ofMean * tally.samples;
        varianceOfPath_.assign(cells, 0);
        for (int cell = 0; cell < cells; ++cell) {
            trial.mean[cell] += tally.values[cell].sum / ofMean;
            trial.variance[cell] += tally.values[cell].squares / ofSquares;
            varianceOfPath_[cell] = tally.values[cell].pathSquares / ofSquares;
        }
        const double rays = double(statistics.bounceRays + statistics.shadowRays);
        trial.cost = rays / lightPathsOfPilot * plan.lightPaths * costOfLightRay;
    }

    /// Never 0: where `path` finds no light at all, it is all alike.
    void setMeanOfPath(const Trial &trial) {
        const double all = std::accumulate(trial.mean.begin(), trial.mean.end(), 0.0) / cells;
        findsLight_ = all > 0;
        meanOfPath_.clear();
        for (double mean : trial.mean)
            meanOfPath_.push_back(all > 0 ? mean + all : 1);
    }

    void followCamera(PathWave &wave, Trial &trial) {
        const LightTally places(window_, 1);
        std::vector<int> pixels(cells);
        std::vector<double> sums(cells), variances(cells);
        const int together = PathWave::capacity / (2 * samplesOfPixel);
        for (int first = 0; first < int(x_.size()); first += together) {
            const int count = std::min(together, int(x_.size()) - first);
            startCamera(wave, {count, x_.data() + first, y_.data() + first, 0, samplesOfPixel});
            follow(wave);
            for (int k = 0; k < count; ++k) {
                double sum = 0, squares = 0;
                for (int s = 0; s < samplesOfPixel; ++s) {
                    double Y = 0;
                    for (int c = 0; c < colorSamples; ++c)
                        Y += double(luminanceWeights[c]) *
                             wave.results.radiance[c][k * samplesOfPixel + s];
                    sum += Y, squares += Y * Y;
                }
                const double mean = sum / samplesOfPixel;
                const int cell =
                    places.cellAt(float(x_[first + k]) + 0.5f, float(y_[first + k]) + 0.5f);
                ++pixels[cell], sums[cell] += mean;
                variances[cell] += std::max(0.0, squares - sum * mean) / (samplesOfPixel - 1);
            }
        }
        for (int cell = 0; cell < cells; ++cell)
            if (pixels[cell] > 0) {
                trial.mean[cell] += sums[cell] / pixels[cell];
                trial.variance[cell] += variances[cell] / pixels[cell];
            }
    }

    FrameContext &frame_;
    IntegratorSettings settings_;
    std::array<int, 4> window_;
    const std::vector<ChannelInfo> light_{{"Ci", colorSamples}, {"Oi", colorSamples}};
    NoMessages silence_;
    /// All samples of a pixel see one place of it: edges are noise whatever the plan.
    PixelFilterSampler middle_;
    std::vector<int> x_, y_;
    std::vector<double> varianceOfPath_, meanOfPath_;
    bool findsLight_ = false; ///< `path` does.
    std::optional<EmissionGuide> guide_;
};

/// Error times cost, where the error is the geometric mean of both that pictures are judged by;
/// `mean` by cell.
double badness(const Trial &trial, const std::vector<double> &mean) {
    const double all = std::accumulate(mean.begin(), mean.end(), 0.0) / double(mean.size());
    double absolute = 0, relative = 0;
    for (std::size_t cell = 0; cell < mean.size(); ++cell) {
        absolute += trial.variance[cell];
        const double dark = floorOfLuminance * all;
        relative += trial.variance[cell] / (mean[cell] * mean[cell] + dark * dark);
    }
    return std::sqrt(absolute * relative) * trial.cost;
}

/// What serves the frame best, as far as the pilots tell.
BidirectionalPlan chooseTechniques(const FrameContext &frame, Pilot &pilot, EmissionGuide &guide) {
    std::vector<BidirectionalPlan> plans;
    std::vector<Trial> trials;
    std::vector<double> mean;
    double vertices = 1;
    const BidirectionalWishes &wishes = frame.settings.bidirectional;
    for (BidirectionalPlan plan : candidates) {
        plan.verticesPerPath = vertices;
        plan.trust = wishes.trust;
        plans.push_back(plan), trials.push_back(pilot.run(plan));
        // The richest plan is the last: it knows all light best.
        mean = trials.back().mean;
        if (plan.lightPaths > 0)
            continue;
        guide = pilot.learn(roundsOfPilot);
        vertices = pilot.verticesPerPath();
        if (!(vertices > 0))
            return {};
        if (wishes.lightPaths)
            return {*wishes.lightPaths, wishes.connections.value_or(0), vertices, wishes.trust};
    }
    for (std::size_t cell = 0; cell < mean.size(); ++cell)
        trials[0].variance[cell] += pilot.varianceOfPath()[cell];
    std::size_t best = 0;
    double least = wishes.merges ? INFINITY : worthLeavingPath * badness(trials[0], mean);
    for (std::size_t k = 1; k < plans.size(); ++k) {
        // Pilots do not merge, and know nothing of what few light paths would cost there.
        if (wishes.merges && plans[k].lightPaths < 1)
            continue;
        if (const double own = badness(trials[k], mean); own < least)
            best = k, least = own;
    }
    if (best > 0 && std::ranges::any_of(guide.lights, [](auto &grid) { return grid.has_value(); }))
        guide = pilot.learn(roundsOfFrame);
    return plans[best];
}

} // namespace

bool lightsMayBeginPaths(const FrameContext &frame) {
    if (!frame.scene.lights().startPaths())
        return false;
    const std::string reason = frame.scene.whyVolumesStopLightPaths();
    if (!reason.empty())
        frame.diagnostics.warning({}, reason + ": no path begins at lights in this frame, it is "
                                               "rendered as by \"path\"");
    return reason.empty();
}

BidirectionalPlan planTechniques(FrameContext &frame, EmissionGuide &guide) {
    if (!lightsMayBeginPaths(frame))
        return {};
    Pilot pilot(frame);
    BidirectionalPlan plan = chooseTechniques(frame, pilot, guide);
    if (frame.settings.bidirectional.merges && plan.lightPaths > 0)
        plan.merging = pilot.planMerging(plan.lightPaths);
    return plan;
}

} // namespace candela
