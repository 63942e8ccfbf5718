// SPDX-License-Identifier: Apache-2.0
#include "light/bidir/plan.h"

#include "light/bidir/pilot.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// What a pilot asks about: no light paths at all, and three plans with them.
constexpr BidirectionalPlan candidates[] = {{0, 0}, {0.25, 0}, {1, 0}, {1, 1}};
/// The first of them that merging is done with: of light paths there is one a sample.
constexpr std::size_t leastMerging = 2;

/// Of learning where light paths begin best: for the pilots, and for the frame, if it has such
/// paths.
constexpr int roundsOfPilot = 3, roundsOfFrame = 64;
/// Pictures are judged by the luminance's error over its mean, and over the place's own with this
/// share of the mean besides.
constexpr double floorOfLuminance = 0.1;

/// Few samples a pixel do not show how much more evenly many of them lie; those of light paths do
/// not lie evenly in pixels. So `path` is left only for what promises to be this much better.
constexpr double worthLeavingPath = 0.5;

/// Light paths of a frame whose camera paths are those of `path`, for the light that `path` has no
/// way to find: at least so many for each sample of a pixel, and for each of all pixels; and at
/// most for each of a pixel, whatever there is to be found.
constexpr double leastBesidePath = 1.0 / 16, leastOfAllPixels = 512, mostBesidePath = 1;

/// Error times cost, where the error is the geometric mean of both that pictures are judged by;
/// `mean` by cell.
double badness(const Trial &trial, const std::vector<double> &mean) {
    const double all = sumOf(mean) / double(mean.size());
    double absolute = 0, relative = 0;
    for (std::size_t cell = 0; cell < mean.size(); ++cell) {
        absolute += trial.variance[cell];
        const double dark = floorOfLuminance * all;
        relative += trial.variance[cell] / (mean[cell] * mean[cell] + dark * dark);
    }
    return std::sqrt(absolute * relative) * trial.cost;
}

/// Some light without extent begins paths, and some surface may send it on in one direction: what
/// it lights so is found from lights alone, however little of it pilots have seen.
bool pathMayMissLight(const Scene &scene) {
    const std::vector<double> probabilities = scene.lights().startProbabilities();
    bool some = false;
    for (std::size_t k = 0; k < probabilities.size(); ++k)
        some |= probabilities[k] > 0 && scene.lights().guidedPlace(std::int32_t(k) + 1, {}, {});
    const auto asksOneDirection = [](const ir::LightRequest &request) {
        return request.kind == ir::LightRequest::Kind::Trace ||
               request.form == ir::ConeForm::Extended;
    };
    for (int code = 0; some && code < scene.codeCount(); ++code)
        if (std::ranges::any_of(scene.code(code).shader().whole.requests, asksOneDirection))
            return true;
    return false;
}

/// The frame as `path` has it, with some light paths for what that cannot find, if there may be
/// such light: as many as make the best of the time, as far as a pilot of them tells.
BidirectionalPlan planBesidePath(const Scene &scene, const Trial &path, Pilot &pilot,
                                 EmissionGuide &guide) {
    BidirectionalPlan plan;
    if (!pathMayMissLight(scene))
        return plan;
    guide = pilot.learn(roundsOfFrame, true);
    const Trial beside = pilot.runBesidePath();
    const double best =
        std::sqrt(sumOf(beside.variance) * path.cost / (sumOf(path.variance) * beside.cost));
    plan.lightPaths =
        std::isfinite(best) ? std::clamp(best, leastBesidePath, mostBesidePath) : leastBesidePath;
    plan.lightPaths = std::max(plan.lightPaths, leastOfAllPixels / pilot.pixels());
    plan.besidePath = true;
    return plan;
}

/// Where light paths have no vertices, there is nothing to connect with.
BidirectionalPlan wishedPlan(const BidirectionalWishes &wishes, double vertices) {
    if (vertices > 0)
        return {*wishes.lightPaths, wishes.connections.value_or(0), vertices, wishes.trust};
    return {*wishes.lightPaths, 0, 1, wishes.trust};
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
        if (wishes.lightPaths)
            return wishedPlan(wishes, vertices);
        if (!(vertices > 0))
            return planBesidePath(frame.scene, trials[0], pilot, guide);
    }
    const Trial path = trials[0];
    for (std::size_t cell = 0; cell < mean.size(); ++cell)
        trials[0].variance[cell] += pilot.varianceOfPath()[cell];
    // Pilots do not merge: they know nothing of what few light paths would cost there, and may see
    // no light at all.
    std::size_t best = wishes.merges ? leastMerging : 0;
    double least = wishes.merges ? INFINITY : worthLeavingPath * badness(trials[0], mean);
    for (std::size_t k = std::max<std::size_t>(best, 1); k < plans.size(); ++k)
        if (const double own = badness(trials[k], mean); own < least)
            best = k, least = own;
    if (best == 0)
        return planBesidePath(frame.scene, path, pilot, guide);
    if (std::ranges::any_of(guide.lights, [](auto &grid) { return grid.has_value(); }))
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
    const BidirectionalWishes &wishes = frame.settings.bidirectional;
    if (!wishes.merges || !(plan.lightPaths > 0) || plan.besidePath)
        return plan;
    plan.merging = pilot.planMerging(plan.lightPaths);
    if (!wishes.lightPaths)
        plan.lightPaths = std::max(plan.lightPaths, pilot.lightPathsOf(plan.merging));
    return plan;
}

} // namespace candela
