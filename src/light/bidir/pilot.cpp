// SPDX-License-Identifier: Apache-2.0
#include "light/bidir/pilot.h"

#include "light/bidir/eye_wave.h"
#include "light/bidir/learn_emission.h"
#include "light/bidir/no_picture.h"
#include "light/path/stages.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace candela {

namespace {

/// Of a pilot: samples of a pixel, and pixels; small frames have smaller ones. How many samples the
/// frame takes has no say: a picture may be continued.
constexpr int samplesOfPixel = 4, mostPixels = 4096, leastPixels = 512, pilotShare = 16;
/// Samples that are so much brighter than their surroundings are taken for rare: a pilot of `path`
/// may have missed them.
constexpr double rareLight = 8;
constexpr float tinyWidth = 1e-3f;
constexpr int lightPathsOfPilot = 4096;
/// A ray of a light path costs more than one of a camera path, with the connection to the lens; and
/// a connection of each vertex, as a share of all that a camera path costs. Measured on rooms of
/// matte and plastic walls.
constexpr double costOfLightRay = 1.6, costOfConnections = 1.4;
/// A round of merging has as many light paths as fill a picture of this many pixels, if there is
/// one path a pixel; small frames put some samples of a pixel together, and take more paths for
/// each.
constexpr double pathsOfRound = 1 << 16;
constexpr int mostSamplesOfRound = 16;
/// Discs that are merged over are at first so many pixels wide, and of small frames as wide as if
/// they had so many pixels along a side: what is spread over much of a wall is lost beyond its
/// ends.
constexpr float widthInPixels = 6;
constexpr double leastSide = 256;

constexpr int cells = LightTally::cells * LightTally::cells;

} // namespace

double sumOf(const std::vector<double> &values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

Pilot::Pilot(FrameContext &frame)
    : frame_(frame), settings_(frame.settings), window_(wholeFrame(frame.scene)),
      middle_({"box", tinyWidth, tinyWidth}, silence_) {
    settings_.seed = frame.settings.seed * 0x9e3779b9u + 0x7f4a7c15u; // Other samples.
    const int wanted = int(pixels() / pilotShare);
    choosePixels(std::clamp(wanted, leastPixels, mostPixels));
}

double Pilot::verticesPerPath() {
    settings_.kind = IntegratorKind::Bidirectional;
    TransportStatistics statistics;
    FrameContext frame = pilotFrame(statistics, frame_.filter);
    NoPicture nothing;
    LightWave wave(frame, {0, 1}, nothing);
    startLight(wave, 0, lightPathsOfPilot);
    follow(wave);
    return double(wave.kept.size()) / lightPathsOfPilot;
}

EmissionGuide Pilot::learn(int rounds, bool besidePath) {
    settings_.kind = IntegratorKind::Bidirectional;
    TransportStatistics statistics;
    FrameContext frame = pilotFrame(statistics, frame_.filter);
    guide_ = learnEmission(frame, meanOfPath_, x_, y_, rounds, besidePath);
    return *guide_;
}

MergingPlan Pilot::planMerging(double lightPaths) {
    const BidirectionalWishes &wishes = settings_.bidirectional;
    MergingPlan plan;
    plan.trust = wishes.trustInMerging;
    const float shrunk = float(std::min(1.0, std::sqrt(pixels()) / leastSide));
    plan.radius = wishes.radius.value_or(widthInPixels / 2 * widthOfPixels() * shrunk);
    plan.samplesOfRound = 1;
    while (plan.samplesOfRound < mostSamplesOfRound &&
           lightPaths * pixels() * plan.samplesOfRound < pathsOfRound)
        plan.samplesOfRound *= 2;
    return plan;
}

double Pilot::lightPathsOf(const MergingPlan &plan) const {
    return pathsOfRound / (pixels() * plan.samplesOfRound);
}

Trial Pilot::run(const BidirectionalPlan &plan) {
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

Trial Pilot::runBesidePath() {
    settings_.kind = IntegratorKind::Bidirectional;
    TransportStatistics statistics;
    LightVertices nothing;
    Trial trial;
    trial.variance.assign(cells, 0), trial.mean.assign(cells, 0);
    followLight({.lightPaths = 1, .besidePath = true}, statistics, nothing, trial);
    return trial;
}

FrameContext Pilot::pilotFrame(TransportStatistics &statistics, const PixelFilterSampler &filter) {
    return FrameContext(frame_.scene, settings_, filter, light_, statistics, silence_,
                        guide_ ? &*guide_ : nullptr);
}

/// Spread over the frame (Roberts' sequence).
void Pilot::choosePixels(int count) {
    count = int(std::min<double>(count, pixels()));
    for (int k = 0; k < count; ++k) {
        const double u = std::fmod(0.5 + (k + 1) * 0.7548776662466927, 1.0);
        const double v = std::fmod(0.5 + (k + 1) * 0.5698402909980532, 1.0);
        x_.push_back(window_[0] + int(u * (window_[1] - window_[0])));
        y_.push_back(window_[2] + int(v * (window_[3] - window_[2])));
    }
}

/// At what the camera sees, the median, metres; 0 if it sees nothing.
float Pilot::widthOfPixels() {
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
                wave.active.rays.origin[2][i] + wave.hits.t[i] * wave.active.rays.direction[2][i]));
    if (widths.empty())
        return 0;
    const auto middle = widths.begin() + std::ptrdiff_t(widths.size() / 2);
    std::ranges::nth_element(widths, middle);
    return *middle;
}

void Pilot::followLight(const BidirectionalPlan &plan, TransportStatistics &statistics,
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
    const double inCell = pixels() / cells;
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
void Pilot::setMeanOfPath(const Trial &trial) {
    const double all = sumOf(trial.mean) / cells;
    findsLight_ = all > 0;
    meanOfPath_.clear();
    for (double mean : trial.mean)
        meanOfPath_.push_back(all > 0 ? mean + all : 1);
}

void Pilot::followCamera(PathWave &wave, Trial &trial) {
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

} // namespace candela
