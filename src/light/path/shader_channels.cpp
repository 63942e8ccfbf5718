// SPDX-License-Identifier: Apache-2.0
#include "light/path/shader_channels.h"

#include "light/path/first_hit.h"
#include "light/path/stages.h"
#include "world/scene/segments.h"

#include <algorithm>

namespace candela {

namespace {

bool isColor(const ir::ShaderParameter &parameter) { return parameter.type == "color"; }

/// The numbers that an output parameter has: `defaults` holds them all.
ChannelInfo channelOf(const ir::ShaderParameter &parameter) {
    const bool isPlace =
        parameter.type == "point" || parameter.type == "vector" || parameter.type == "normal";
    return {parameter.name, int(parameter.defaults.size()), isPlace};
}

/// What a first hit tells goes by its own name.
bool isShown(const ir::ShaderParameter &parameter) {
    const std::vector<ChannelInfo> others = firstHitChannels();
    return parameter.output && parameter.type != "string" &&
           std::ranges::find(others, parameter.name, &ChannelInfo::name) == others.end();
}

/// Where a channel's planes begin, in the order of SampleSink::channels() behind Ci and Oi.
int firstPlane(std::span<const ChannelInfo> channels, std::size_t channel) {
    int plane = 0;
    for (std::size_t k = 2; k < channel; ++k)
        plane += channels[k].components;
    return plane;
}

/// Adds what surfaces with the opacity in front let through, or all of it.
void addSeen(const PathsAtVertices &paths, int count, const float *value, int sample, float *to) {
    for (int i = 0; i < count; ++i) {
        if (!paths.seen[i])
            continue;
        float through = 0;
        for (int c = 0; c < colorSamples; ++c)
            if (sample < 0 || sample == c)
                through += paths.throughput[c][i];
        to[paths.slot[i]] += value[i] * (sample < 0 ? through / colorSamples : through);
    }
}

/// The rows of light that the vertices have been given, or are given now.
struct GivenLight {
    const LightRows *rows = nullptr;
    int count = 0;
};

GivenLight lightFor(PathWave &wave) {
    const int code = wave.chunk.code;
    if (!wave.frame.shaderChannels.needLight(code))
        return {};
    if (wave.frame.settings.kind == IntegratorKind::Classic)
        return {&wave.classic->rows, wave.frame.scene.lights().count()};
    // Of what is affine in the light, one round has the right mean.
    const int rows =
        wave.chunk.vertices.code().facts().affine ? gatherLight(wave, 1) : wave.gathered->rowCount;
    return {&wave.gathered->rows, rows};
}

} // namespace

std::vector<ChannelInfo> outputParametersOf(const Scene &scene) {
    std::vector<ChannelInfo> channels;
    const auto add = [&](const ShaderCode &code) {
        for (const ir::ShaderParameter &parameter : code.shader().parameters)
            if (isShown(parameter) &&
                std::ranges::find(channels, parameter.name, &ChannelInfo::name) == channels.end())
                channels.push_back(channelOf(parameter));
    };
    for (int code = 0; code < scene.codeCount(); ++code)
        add(scene.code(code));
    for (int number = 1; number < scene.mediaCount(); ++number)
        add(*scene.medium(number).code);
    return channels;
}

namespace {

/// What of the code's answer to the question is to be seen where.
std::vector<ShaderChannelPlane> planesOf(const ShaderCode &code, ir::Question which,
                                         std::span<const ChannelInfo> channels) {
    std::vector<ShaderChannelPlane> planes;
    for (const ir::ShaderParameter &parameter : code.shader().parameters) {
        const auto channel = std::ranges::find(channels, parameter.name, &ChannelInfo::name);
        if (!isShown(parameter) || channel == channels.end() ||
            channel->components != int(parameter.defaults.size()))
            continue;
        const ir::Function &function = code.question(which).function;
        const int first = firstPlane(channels, std::size_t(channel - channels.begin()));
        for (int c = 0; c < channel->components; ++c)
            planes.push_back({first + c, ir::slotOf(function.outputs, parameter.name, c),
                              isColor(parameter) ? c % colorSamples : -1});
    }
    return planes;
}

} // namespace

ShaderChannels::ShaderChannels(const Scene &scene, std::span<const ChannelInfo> channels)
    : codes_(std::size_t(scene.codeCount())) {
    for (int number = 0; number < scene.codeCount(); ++number) {
        const ShaderCode &code = scene.code(number);
        Code &own = codes_[std::size_t(number)];
        own.planes = planesOf(code, ir::Question::Outputs, channels);
        if (own.planes.empty())
            continue;
        own.needLight = ir::asksForLight(code.question(ir::Question::Outputs).function);
        empty_ = false;
    }
    for (int number = 1; number < scene.mediaCount(); ++number) {
        const ShaderCode &code = *scene.medium(number).code;
        if (const auto planes = planesOf(code, Segments::askedOf(code), channels); !planes.empty())
            volumes_[&code] = planes;
    }
}

void seeOutputParameters(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    const ShaderChannels &channels = wave.frame.shaderChannels;
    if (channels.empty() || wave.purpose != Purpose::Camera || channels.of(chunk.code).empty() ||
        std::none_of(chunk.paths.seen, chunk.paths.seen + chunk.count(),
                     [](int seen) { return seen != 0; }))
        return;
    const GivenLight light = lightFor(wave);
    const LightRows *rows = light.rows;
    const std::span<float *const> values =
        chunk.vertices.outputParameters(light.count, light.count > 0 ? rows->L(0).data() : nullptr,
                                        light.count > 0 ? rows->Cl(0).data() : nullptr,
                                        light.count > 0 ? rows->light(0) : nullptr, chunk.ambient);
    for (const ShaderChannelPlane &shown : channels.of(chunk.code))
        addSeen(chunk.paths, chunk.count(), values[std::size_t(shown.output)], shown.sample,
                wave.results.channels[shown.plane]);
}

} // namespace candela
