// SPDX-License-Identifier: Apache-2.0
#include "image/difference_picture.h"

#include "foundation/units/color.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candela {

namespace {

using Rgb = std::array<float, 3>;

/// White for 0, red for 1, blue for -1.
Rgb signedColor(float at) {
    const float t = std::isfinite(at) ? std::clamp(at, -1.0f, 1.0f) : 1.0f;
    return t >= 0 ? Rgb{1, 1 - t, 1 - t} : Rgb{1 + t, 1 + t, 1};
}

/// Black, red, yellow, white.
Rgb glow(float at) {
    const float t = 3 * std::clamp(at, 0.0f, 1.0f);
    return {std::min(t, 1.0f), std::clamp(t - 1, 0.0f, 1.0f), std::clamp(t - 2, 0.0f, 1.0f)};
}

Picture emptyPicture(const FrameWindow &window) {
    Picture picture;
    picture.window = window;
    picture.metadata = {{"renderer", "Candela"}};
    return picture;
}

template <class ColorOf> Picture coloredBy(const FrameWindow &window, ColorOf colorOf) {
    Picture picture = emptyPicture(window);
    picture.hasDisplayValues = true;
    for (int c = 0; c < 3; ++c)
        picture.channels.push_back({std::string(1, "RGB"[c]), {}});
    for (std::size_t i = 0; i < window.pixels(); ++i) {
        const Rgb color = colorOf(i);
        for (std::size_t c = 0; c < 3; ++c)
            picture.channels[c].values.push_back(color[c]);
    }
    return picture;
}

/// The luminance, or else the first channel that both have.
std::vector<float> brightnessOf(const Picture &picture, const Picture &other) {
    std::vector<float> values(picture.window.pixels(), 0.0f);
    for (int c = 0; c < 3; ++c)
        if (const PictureChannel *channel = picture.find(std::string(1, "RGB"[c])))
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] += luminanceWeights[c] * channel->values[i];
    if (picture.find("R") && other.find("R"))
        return values;
    for (const PictureChannel &channel : picture.channels)
        if (other.find(channel.name))
            return channel.values;
    return values;
}

/// The region of each pixel, row by row.
std::vector<int> regionsOf(const ChannelScores &scores, const FrameWindow &w) {
    std::vector<int> regions(w.pixels());
    for (int k = 0; k < int(scores.regions.size()); ++k) {
        const RegionScore &r = scores.regions[std::size_t(k)];
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; ++x)
                regions[std::size_t(y - w.y0) * w.columns() + (x - w.x0)] = k;
    }
    return regions;
}

} // namespace

Picture differenceOf(const Picture &a, const Picture &b, const std::optional<FlipMap> &flip) {
    Picture picture = emptyPicture(a.window);
    for (const PictureChannel &channel : a.channels)
        if (const PictureChannel *other = b.find(channel.name)) {
            picture.channels.push_back(channel);
            for (std::size_t i = 0; i < channel.values.size(); ++i)
                picture.channels.back().values[i] -= other->values[i];
        }
    if (flip)
        picture.channels.push_back({"flip", flip->values});
    return picture;
}

Picture shownDifference(const Picture &a, const Picture &b, const std::optional<FlipMap> &flip,
                        float full) {
    if (flip)
        return coloredBy(a.window, [&](std::size_t i) { return glow(flip->values[i]); });
    const std::vector<float> ofA = brightnessOf(a, b), ofB = brightnessOf(b, a);
    return coloredBy(a.window, [&](std::size_t i) {
        const float larger = std::max(std::fabs(ofA[i]), std::fabs(ofB[i]));
        return signedColor(ofA[i] == ofB[i] ? 0 : (ofA[i] - ofB[i]) / (full * larger));
    });
}

Picture differenceOf(const SeedComparison &comparison, const FrameWindow &window) {
    Picture picture = emptyPicture(window);
    for (const ChannelScores &scores : comparison.channels) {
        const std::string layer = comparison.channels.size() > 1 ? "." + scores.name : "";
        const std::vector<int> regions = regionsOf(scores, window);
        PictureChannel z{"z" + layer, {}}, difference{"difference" + layer, {}};
        for (int region : regions) {
            const RegionScore &score = scores.regions[std::size_t(region)];
            z.values.push_back(float(score.z));
            difference.values.push_back(float(score.meanA - score.meanB));
        }
        picture.channels.push_back(std::move(z));
        picture.channels.push_back(std::move(difference));
    }
    return picture;
}

Picture shownDifference(const SeedComparison &comparison, const FrameWindow &window) {
    constexpr double full = 5;
    const ChannelScores &scores = comparison.channels.front();
    const std::vector<int> regions = regionsOf(scores, window);
    return coloredBy(window, [&](std::size_t i) {
        return signedColor(float(scores.regions[std::size_t(regions[i])].z / full));
    });
}

} // namespace candela
