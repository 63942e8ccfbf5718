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
/// Little of a lamp's light may reach a small view. As long as paths have shown less of it than
/// this, what lies around the view, so many frames far at first, tells whither to send them.
constexpr int enoughSeen = 512;
constexpr double farthestReach = 32, leastReach = 1;
/// So many tell by themselves where to send paths.
constexpr std::size_t enoughOfLight = 64;
/// What a light keeps of its choice by power.
constexpr double powerShare = 0.5;

using Worth = std::vector<double>;

/// Of a light's square.
struct Place {
    std::array<double, 2> at;
    double worth;
    double beyond = 0; ///< Where it shows, beyond the frame, in frames.
};
using Places = std::vector<Place>;

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
        straight_.resize(power_.size());
        seen_ = around_ = straight_;
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
                            straight_[k].push_back({*place, 1});
            }
        }
    }

    void followLight(int round) {
        const std::array<int, 4> whole = wholeFrame(frame_.scene);
        LightTally tally(whole, double(whole[1]) * whole[3]);
        tally.keepsSplats = true;
        tally.reach = reach_;
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
            const bool isSeen = splat.cell >= 0;
            const double Y = splat.luminance / (isSeen ? darkness_[splat.cell] : 1);
            if (isSeen)
                found_[light - 1] += Y, ++splatsSeen_;
            // Squares are to be integrals over the grid: paths have been drawn by a density.
            if (place && !seen_.empty())
                (isSeen ? seen_ : around_)[light - 1].push_back(
                    {*place, Y * Y * starts.directionPdf[splat.slot], splat.beyond});
        }
    }

    /// The next paths look at less of what lies around, or no more at all.
    void comeNearer() {
        reach_ = splatsSeen_ < enoughSeen ? std::max(reach_ / 2, leastReach) : 0;
        for (Places &places : around_)
            std::erase_if(places, [&](const Place &place) {
                return place.beyond > std::max(reach_, leastReach);
            });
    }

    /// What has been learned so far.
    EmissionGuide guide() const {
        EmissionGuide guide;
        guide.lights.resize(power_.size());
        for (std::size_t k = 0; k < seen_.size(); ++k)
            if (!seen_[k].empty() || !straight_[k].empty() || !around_[k].empty())
                guide.lights[k] = gridOf(k);
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
    NestedGrid gridOf(std::size_t light) const {
        SquareGrid whole = gridOver({}, light);
        const std::optional<Rectangle> part = partOf(light);
        return part ? NestedGrid(std::move(whole), gridOver(*part, light), *part)
                    : NestedGrid(std::move(whole));
    }

    SquareGrid gridOver(const Rectangle &where, std::size_t light) const {
        Worth worth(SquareGrid::cells, evenShare / SquareGrid::cells);
        addShare(sumOver(where, straight_[light]), seen_[light].empty() ? 1 : straightShare, worth);
        addShare(rootsOver(where, seen_[light]), 1, worth);
        addShare(rootsOver(where, aroundOf(light)), 1, worth);
        return SquareGrid(worth);
    }

    /// As long as they are needed.
    const Places &aroundOf(std::size_t light) const {
        static const Places none;
        return seen_[light].size() < enoughOfLight ? around_[light] : none;
    }

    /// Around nearly all that the places are worth, if that is little of the square; farther, the
    /// fewer they are.
    std::optional<Rectangle> partOf(std::size_t light) const {
        constexpr double mostArea = 0.25, leastSize = 1e-4, beyond = 0.25, beyondOfFew = 4;
        Rectangle part;
        for (std::size_t c = 0; c < 2; ++c) {
            double low = 1, high = 0, count = 0;
            for (const Places *places : {&straight_[light], &seen_[light], &aroundOf(light)})
                if (!places->empty()) {
                    const auto [from, to] = mostOf(*places, c);
                    low = std::min(low, from), high = std::max(high, to);
                    count += double(places->size());
                }
            const double more = std::max(leastSize, (high - low) * (beyond + beyondOfFew / count));
            part.low[c] = std::max(0.0, low - more);
            part.size[c] = std::min(1.0, high + more) - part.low[c];
        }
        return part.area() < mostArea ? std::optional(part) : std::nullopt;
    }

    /// Along one side of the square, between which places nearly all of the worth lies.
    static std::pair<double, double> mostOf(const Places &places, std::size_t c) {
        constexpr double leftOut = 0.01; // At either end.
        std::vector<std::pair<double, double>> sorted;
        double all = 0;
        for (const Place &place : places)
            sorted.emplace_back(place.at[c], place.worth), all += place.worth;
        std::ranges::sort(sorted);
        std::pair<double, double> most{sorted.front().first, sorted.back().first};
        double sum = 0;
        for (const auto &[at, worth] : sorted) {
            if (sum <= leftOut * all)
                most.first = at;
            if (sum < (1 - leftOut) * all)
                most.second = at;
            sum += worth;
        }
        return most;
    }

    static Worth sumOver(const Rectangle &where, const Places &places) {
        Worth worth(SquareGrid::cells);
        for (const Place &place : places)
            if (where.holds(place.at[0], place.at[1])) {
                const auto [a, b] = where.within(place.at[0], place.at[1]);
                worth[std::size_t(SquareGrid::cellOf(a, b))] += place.worth;
            }
        return worth;
    }
    static Worth rootsOver(const Rectangle &where, const Places &squares) {
        Worth worth = sumOver(where, squares);
        for (double &each : worth)
            each = std::sqrt(each);
        return worth;
    }

    FrameContext &frame_;
    const std::vector<double> &darkness_;
    std::vector<double> power_;
    /// By light: whither it sends straight to what the camera sees, and where paths begin that show
    /// in the frame, and around it; of these the worth is to be squared light.
    std::vector<Places> straight_, seen_, around_;
    int splatsSeen_ = 0; ///< In the frame.
    double reach_ = farthestReach;
    std::vector<double> found_; ///< Of the light that is seen.
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
        if (!std::has_single_bit(unsigned(round + 1)) && round + 1 < rounds)
            continue;
        guide = learner.guide();
        learner.comeNearer();
    }
    frame.guide = nullptr;
    guide.share = share;
    return guide;
}

} // namespace candela
