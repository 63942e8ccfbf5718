// SPDX-License-Identifier: Apache-2.0
#include "light/bidir/learn_emission.h"

#include "light/bidir/light_wave.h"
#include "light/bidir/no_picture.h"
#include "light/path/stages.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace candela {

namespace {

constexpr int pathsOfRound = PathWave::capacity / 2;
/// Of more lights than this there is too little to be learned of each.
constexpr int mostLights = 64;
/// What a grid keeps for what was not seen, and for the straight lines to what the camera sees.
constexpr double evenShare = 0.1, straightShare = 0.25;
/// Of the paths that are learned from, those that follow what has been learned already.
constexpr double shareWhileLearning = 0.5;
/// What a light keeps of its choice by power.
constexpr double powerShare = 0.5;

using Worth = std::vector<double>;

/// Adds a share that is spread as `worth` is, seen as finely as few samples allow: in the mean of
/// grids from 4 x 4 cells to the finest.
void addShare(const Worth &worth, double share, Worth &to) {
    constexpr int side = SquareGrid::side, coarsest = 4;
    const double all = std::accumulate(worth.begin(), worth.end(), 0.0);
    if (!(all > 0))
        return;
    const int levels = std::bit_width(unsigned(side / coarsest));
    for (int cells = coarsest; cells <= side; cells *= 2) {
        const int step = side / cells;
        Worth coarse(std::size_t(cells) * cells);
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                coarse[row / step * cells + column / step] += worth[row * side + column];
        const double scale = share / (all * levels * step * step);
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                to[row * side + column] += scale * coarse[row / step * cells + column / step];
    }
}

class Learner {
public:
    Learner(FrameContext &frame, const std::vector<double> &darkness, bool besidePath)
        : frame_(frame), darkness_(darkness), power_(frame.scene.lights().startProbabilities()),
          wave_(frame, {1, 0, 0, besidePath}, nothing_) {
        const int shining =
            int(std::ranges::count_if(power_, [](double power) { return power > 0; }));
        found_.resize(power_.size());
        if (shining > mostLights)
            return;
        straight_.assign(power_.size(), Worth(SquareGrid::cells));
        squares_ = straight_;
    }

    /// Point lights send straight to what the camera sees.
    void lookFromCamera(std::span<const int> x, std::span<const int> y) {
        if (straight_.empty())
            return;
        PathWave wave(frame_);
        const int together = PathWave::capacity;
        for (int first = 0; first < int(x.size()); first += together) {
            const int count = std::min(together, int(x.size()) - first);
            startCamera(wave, {count, x.data() + first, y.data() + first, 0, 1});
            trace(wave);
            const RayBatch &rays = wave.active.rays;
            for (int i = 0; i < count; ++i) {
                if (wave.hits.shape[i] == noHit)
                    continue;
                Vec3 P;
                for (int c = 0; c < 3; ++c)
                    P[c] = rays.origin[c][i] + wave.hits.t[i] * rays.direction[c][i];
                for (std::size_t k = 0; k < power_.size(); ++k)
                    if (power_[k] > 0)
                        if (const auto place =
                                frame_.scene.lights().guidedPlaceFor(std::int32_t(k) + 1, P))
                            straight_[k][SquareGrid::cellOf((*place)[0], (*place)[1])] += 1;
            }
        }
    }

    void followLight(int round) {
        const std::array<int, 4> whole = wholeFrame(frame_.scene);
        LightTally tally(whole, double(whole[1]) * whole[3]);
        tally.keepsSplats = true;
        wave_.tally = &tally;
        startLight(wave_, std::int64_t(round + 1) * pathsOfRound, pathsOfRound);
        follow(wave_);
        const LightStarts &starts = wave_.starts;
        for (const LightTally::Splat &splat : tally.splats) {
            const std::int32_t light = starts.light[splat.slot];
            const auto vec3 = [&](const auto &planes) {
                return Vec3{planes[0][splat.slot], planes[1][splat.slot], planes[2][splat.slot]};
            };
            const auto place = frame_.scene.lights().guidedPlace(light, vec3(starts.direction),
                                                                 vec3(starts.origin));
            const double Y = splat.luminance / darkness_[splat.cell];
            found_[light - 1] += Y;
            // Squares are to be integrals over the grid: paths have been drawn by a density.
            if (place && !squares_.empty())
                squares_[light - 1][SquareGrid::cellOf((*place)[0], (*place)[1])] +=
                    Y * Y * starts.directionPdf[splat.slot];
        }
    }

    /// What has been learned so far.
    EmissionGuide guide() const {
        EmissionGuide guide;
        guide.lights.resize(power_.size());
        for (std::size_t k = 0; k < squares_.size(); ++k) {
            Worth seen = squares_[k];
            for (double &worth : seen)
                worth = std::sqrt(worth);
            const bool isSeen = std::ranges::any_of(seen, [](double worth) { return worth > 0; });
            if (!isSeen &&
                std::ranges::none_of(straight_[k], [](double worth) { return worth > 0; }))
                continue;
            Worth worth(SquareGrid::cells, evenShare / SquareGrid::cells);
            addShare(straight_[k], isSeen ? straightShare : 1, worth);
            addShare(seen, 1, worth);
            guide.lights[k].emplace(worth);
        }
        const double all = std::accumulate(found_.begin(), found_.end(), 0.0);
        double sum = 0;
        for (std::size_t k = 0; k < power_.size(); ++k) {
            const double share = all > 0 ? found_[k] / all : power_[k];
            guide.probability.push_back(powerShare * power_[k] + (1 - powerShare) * share);
            guide.cumulative.push_back(sum += guide.probability.back());
        }
        return guide;
    }

private:
    FrameContext &frame_;
    const std::vector<double> &darkness_;
    std::vector<double> power_;
    std::vector<Worth> straight_, squares_; ///< By light.
    std::vector<double> found_;             ///< Of the light that is seen.
    NoPicture nothing_;
    LightWave wave_;
};

} // namespace

EmissionGuide learnEmission(FrameContext &frame, const std::vector<double> &darkness,
                            std::span<const int> x, std::span<const int> y, int rounds,
                            bool besidePath) {
    Learner learner(frame, darkness, besidePath);
    if (!besidePath)
        learner.lookFromCamera(x, y);
    EmissionGuide guide = learner.guide();
    const double share = guide.share;
    for (int round = 0; round < rounds; ++round) {
        guide.share = shareWhileLearning;
        frame.guide = &guide;
        learner.followLight(round);
        if (std::has_single_bit(unsigned(round + 1)) || round + 1 == rounds)
            guide = learner.guide();
    }
    frame.guide = nullptr;
    guide.share = share;
    return guide;
}

} // namespace candela
