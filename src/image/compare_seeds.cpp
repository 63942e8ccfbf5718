// SPDX-License-Identifier: Apache-2.0
#include "image/compare_seeds.h"

#include "foundation/base/student.h"
#include "foundation/units/color.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace candela {

namespace {

/// A channel, or the luminance for the name "".
std::optional<std::vector<float>> valuesOf(const Picture &picture, const std::string &name) {
    std::vector<float> values(picture.window.pixels(), 0.0f);
    const auto add = [&](const std::string &channel, float weight) {
        const PictureChannel *from = picture.find(channel);
        for (std::size_t i = 0; from && i < values.size(); ++i)
            values[i] += weight * from->values[i];
        return from != nullptr;
    };
    bool found = true;
    for (int c = 0; name.empty() && c < 3; ++c)
        found &= add(std::string(1, "RGB"[c]), luminanceWeights[c]);
    if (!name.empty())
        found = add(name, 1);
    for (float &value : values)
        value = std::isfinite(value) ? value : 0.0f;
    return found ? std::optional(std::move(values)) : std::nullopt;
}

using Group = std::vector<std::vector<float>>; ///< Values of pictures.

double meanOver(const std::vector<float> &values, const FrameWindow &w, const RegionScore &region) {
    double sum = 0;
    for (int y = region.y0; y < region.y1; ++y)
        for (int x = region.x0; x < region.x1; ++x)
            sum += double(values[std::size_t(y - w.y0) * w.columns() + (x - w.x0)]);
    return sum / double(region.x1 - region.x0) / double(region.y1 - region.y0);
}

MeanAndError meanOver(const Group &group, const FrameWindow &w, const RegionScore &region) {
    std::vector<double> means;
    for (const std::vector<float> &values : group)
        means.push_back(meanOver(values, w, region));
    return means.size() > 1 ? meanAndError(means) : MeanAndError{means[0], 0};
}

/// The normal deviate beyond which, on both sides, so much probability lies.
double deviateOf(double probability) {
    double low = 0, high = 40;
    for (int step = 0; step < 100; ++step) {
        const double middle = (low + high) / 2;
        (std::erfc(middle / std::sqrt(2.0)) > probability ? low : high) = middle;
    }
    return high;
}

/// Welch's degrees of freedom, rounded down: never surer than the pictures allow.
int degreesOfFreedom(const RegionScore &r, std::size_t a, std::size_t b) {
    const double u = r.errorA * r.errorA, v = r.errorB * r.errorB;
    const double divisor = u * u / double(a - 1) + (b > 1 ? v * v / double(b - 1) : 0);
    return divisor > 0 ? std::max(1, int((u + v) * (u + v) / divisor)) : 1;
}

void score(const Group &a, const Group &b, const FrameWindow &w, RegionScore &region) {
    const MeanAndError ofA = meanOver(a, w, region), ofB = meanOver(b, w, region);
    region.meanA = ofA.mean, region.errorA = ofA.standardError;
    region.meanB = ofB.mean, region.errorB = ofB.standardError;
    const double difference = ofA.mean - ofB.mean;
    const double error = std::hypot(ofA.standardError, ofB.standardError);
    if (difference == 0)
        return;
    // What does not vary at all and differs is different.
    region.probability =
        error > 0 ? std::max(0.0, studentTail(std::fabs(difference) / error,
                                              degreesOfFreedom(region, a.size(), b.size())))
                  : 0;
    region.z = std::copysign(deviateOf(region.probability), difference);
}

ChannelScores scoresOf(const Group &a, const Group &b, const FrameWindow &w, int size) {
    ChannelScores scores;
    scores.whole = {w.x0, w.y0, w.x1, w.y1};
    score(a, b, w, scores.whole);
    scores.columns = (w.columns() + size - 1) / size;
    for (int y = w.y0; y < w.y1; y += size)
        for (int x = w.x0; x < w.x1; x += size) {
            RegionScore region{x, y, std::min(x + size, w.x1), std::min(y + size, w.y1)};
            score(a, b, w, region);
            if (!scores.regions.empty() &&
                std::fabs(region.z) > std::fabs(scores.regions[std::size_t(scores.worst)].z))
                scores.worst = int(scores.regions.size());
            scores.regions.push_back(region);
        }
    const double count = double(scores.regions.size());
    for (const RegionScore &region : scores.regions)
        scores.meanSquareZ += region.z * region.z / count;
    scores.familyWise =
        std::min(1.0, count * scores.regions[std::size_t(scores.worst)].probability);
    return scores;
}

std::string flawOf(std::span<const Picture> a, std::span<const Picture> b) {
    if (a.size() < 2 || b.empty())
        return "z-scores take at least two pictures of one kind, of different seeds";
    for (std::span<const Picture> group : {a, b})
        for (const Picture &picture : group)
            if (picture.window != a[0].window)
                return "the sizes of the pictures differ";
    return a[0].window.pixels() > 0 ? "" : "the pictures have no pixels";
}

bool differs(const ChannelScores &scores) {
    return std::min(scores.familyWise, scores.whole.probability) < seedSignificance / 2;
}

std::string textOf(const RegionScore &r) {
    return fmt::format("{:.6g} +- {:.2g} and {:.6g} +- {:.2g} ({:+.3g} %), z {:+.2f}, p = {:.2g}",
                       r.meanA, r.errorA, r.meanB, r.errorB,
                       r.meanB != 0 ? 100 * (r.meanA / r.meanB - 1) : 0.0, r.z, r.probability);
}

} // namespace

SeedComparison compareSeeds(std::span<const Picture> a, std::span<const Picture> b,
                            const SeedSettings &settings) {
    SeedComparison result;
    result.problem = flawOf(a, b);
    result.referenceIsExact = b.size() == 1;
    std::vector<std::string> names = settings.channels;
    if (names.empty())
        names.emplace_back();
    if (!result.problem.empty())
        return result;
    for (const std::string &name : names) {
        Group groups[2];
        for (int k = 0; k < 2 && result.problem.empty(); ++k)
            for (const Picture &picture : k == 0 ? a : b) {
                auto values = valuesOf(picture, name);
                if (values)
                    groups[k].push_back(std::move(*values));
                else
                    result.problem = "a picture lacks the channel" +
                                     (name.empty() ? "s R, G and B" : " \"" + name + "\"");
            }
        if (!result.problem.empty())
            return result;
        result.channels.push_back(scoresOf(groups[0], groups[1], a[0].window, settings.regionSize));
        result.channels.back().name = name.empty() ? "luminance" : name;
    }
    return result;
}

int exitCodeOf(const SeedComparison &comparison) {
    if (!comparison.problem.empty())
        return 2;
    return std::ranges::any_of(comparison.channels, differs) ? 1 : 0;
}

std::string reportOf(const SeedComparison &comparison) {
    if (!comparison.problem.empty())
        return "not comparable: " + comparison.problem + "\n";
    std::string text;
    if (comparison.referenceIsExact)
        text += "the second picture is taken to have no error: there is one of it\n";
    for (const ChannelScores &scores : comparison.channels) {
        const RegionScore &worst = scores.regions[std::size_t(scores.worst)];
        text += fmt::format("{:<12} means {}\n", scores.name, textOf(scores.whole));
        text += fmt::format("{:<12} worst of {} regions, ({}, {}) to ({}, {}): {}; {:.2g} among "
                            "all\n",
                            "", scores.regions.size(), worst.x0, worst.y0, worst.x1 - 1,
                            worst.y1 - 1, textOf(worst), scores.familyWise);
        text += fmt::format("{:<12} mean square of z {:.3g}: chance alone makes it 1\n", "",
                            scores.meanSquareZ);
    }
    return text +
           (exitCodeOf(comparison) == 0 ? "the same, as far as these seeds tell\n" : "different\n");
}

} // namespace candela
