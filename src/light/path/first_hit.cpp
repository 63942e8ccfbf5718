// SPDX-License-Identifier: Apache-2.0
#include "light/path/first_hit.h"

#include "foundation/units/color.h"

#include <optional>

namespace candela {

namespace {

struct Source {
    const char *name;
    int components;
    FirstHitPlane first;
};

constexpr float farAway = 1e30f; ///< RI_INFINITY: the depth of the background.

constexpr Source sources[] = {
    {"z", 1, {int(ShaderInput::P) + 2, false, farAway, -1, true}},
    {"P", 3, {int(ShaderInput::P), false, 0}},
    {"N", 3, {int(ShaderInput::N), false, 0}},
    {"Ng", 3, {int(ShaderInput::Ng), false, 0}},
    {"u", 1, {int(ShaderInput::u), false, 0}},
    {"v", 1, {int(ShaderInput::v), false, 0}},
    {"s", 1, {int(ShaderInput::s), false, 0}},
    {"t", 1, {int(ShaderInput::t), false, 0}},
    {"Cs", 3, {int(ShaderInput::Cs), false, 0}},
    {"Os", 3, {int(ShaderInput::Os), false, 0}},
    {"id", 1, {-1, true, 0}},
    {"albedo", colorSamples, {-1, false, 0, 0}},
};

std::optional<Source> sourceOf(const ChannelInfo &channel) {
    for (const Source &source : sources)
        if (channel.name == source.name && channel.components == source.components)
            return source;
    return std::nullopt;
}

} // namespace

std::vector<ChannelInfo> firstHitChannels() {
    std::vector<ChannelInfo> channels;
    for (const Source &source : sources)
        channels.push_back({source.name, source.components});
    return channels;
}

std::vector<FirstHitPlane> firstHitPlanes(std::span<const ChannelInfo> channels) {
    std::vector<FirstHitPlane> planes;
    for (const ChannelInfo &channel : channels.subspan(2)) {
        FirstHitPlane plane = sourceOf(channel).value_or(Source{}).first;
        for (int c = 0; c < channel.components; ++c) {
            planes.push_back(plane);
            if (plane.input >= 0)
                ++plane.input;
            if (plane.albedo >= 0)
                ++plane.albedo;
        }
    }
    return planes;
}

} // namespace candela
