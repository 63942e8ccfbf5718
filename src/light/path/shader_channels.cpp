// SPDX-License-Identifier: Apache-2.0
#include "light/path/shader_channels.h"

#include "light/path/first_hit.h"
#include "light/path/stages.h"
#include "light/path/steps.h"
#include "world/scene/segments.h"

#include <algorithm>

namespace candela {

namespace {

bool isColor(const ir::ShaderParameter &parameter) { return parameter.type == "color"; }

/// The numbers that an output parameter has: `defaults` holds them all.
ChannelInfo channelOf(const ir::ShaderParameter &parameter) {
    const bool isPlace =
        parameter.type == "point" || parameter.type == "vector" || parameter.type == "normal";
    const bool isList = parameter.arraySize > 1 || parameter.type == "matrix";
    return {parameter.name, int(parameter.defaults.size()), isPlace && !isList, isList};
}

/// What a first hit tells goes by its own name.
bool isShown(const ir::ShaderParameter &parameter) {
    static const std::vector<ChannelInfo> others = firstHitChannels();
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

std::vector<const ShaderCode *> volumesOf(const Scene &scene) {
    std::vector<const ShaderCode *> codes;
    for (int number = 1; number < scene.mediaCount(); ++number)
        if (const ShaderCode *code = scene.medium(number).code.get();
            std::ranges::find(codes, code) == codes.end())
            codes.push_back(code);
    return codes;
}

/// Which of the question's outputs the channels show.
std::vector<ShaderChannelPlane> planesOf(const ShaderCode &code, ir::Question which,
                                         std::span<const ChannelInfo> channels) {
    std::vector<ShaderChannelPlane> planes;
    for (const ir::ShaderParameter &parameter : code.shader().parameters) {
        const auto channel = std::ranges::find(channels, parameter.name, &ChannelInfo::name);
        if (!isShown(parameter) || channel == channels.end() ||
            channel->components != int(parameter.defaults.size()))
            continue;
        const auto &outputs = code.question(which).function.outputs;
        const int first = firstPlane(channels, std::size_t(channel - channels.begin()));
        const auto output = ir::OutputName::ofParameter(parameter.name);
        for (int c = 0; c < channel->components; ++c)
            planes.push_back({first + c, ir::slotOf(outputs, output, c),
                              isColor(parameter) ? c % colorSamples : -1});
    }
    return planes;
}

} // namespace

std::vector<ChannelInfo> outputParametersOf(const Scene &scene) {
    std::vector<const ShaderCode *> codes;
    for (int code = 0; code < scene.codeCount(); ++code)
        codes.push_back(&scene.code(code));
    for (const ShaderCode *code : volumesOf(scene))
        codes.push_back(code);
    std::vector<ChannelInfo> channels;
    for (const ShaderCode *code : codes)
        for (const ir::ShaderParameter &parameter : code->shader().parameters)
            if (isShown(parameter) &&
                std::ranges::find(channels, parameter.name, &ChannelInfo::name) == channels.end())
                channels.push_back(channelOf(parameter));
    return channels;
}

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
    for (const ShaderCode *code : volumesOf(scene))
        volumes_[code] = planesOf(*code, Segments::askedOf(*code), channels);
}

std::span<const ShaderChannelPlane> ShaderChannels::ofVolume(const ShaderCode &code) const {
    const auto found = volumes_.find(&code);
    return found == volumes_.end() ? std::span<const ShaderChannelPlane>() : found->second;
}

void addSeen(PathWave &wave, const ShaderChannelPlane &shown, const float *value,
             const std::uint16_t *active) {
    const PathsAtVertices &paths = wave.chunk.paths;
    float *to = wave.results.channels[shown.plane];
    for (int i = 0; i < wave.chunk.count(); ++i) {
        const bool asked = !active || (active[i / laneBlock] >> (i % laneBlock) & 1);
        if (!paths.seen[i] || !asked)
            continue;
        float through = 0;
        for (int c = 0; c < colorSamples; ++c)
            if (shown.sample < 0 || shown.sample == c)
                through += paths.throughput[c][i];
        to[paths.slot[i]] += value[i] * (shown.sample < 0 ? through / colorSamples : through);
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
        addSeen(wave, shown, values[std::size_t(shown.output)], nullptr);
}

} // namespace candela
