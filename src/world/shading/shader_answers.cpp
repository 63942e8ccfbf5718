// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_answers.h"

#include "world/shading/attribute_value.h"

#include "interface/ri/declarations.h"
#include "language/ir/core/print_format.h"
#include "language/runtime/shader_abi.h"

#include "world/shading/volume_lights.h"

#include <algorithm>
#include <cstdio>

namespace candela {

namespace {

/// printf() in a loop at every point could fill a disk.
constexpr std::size_t mostPrintedBytes = 16 << 20;

/// Options that have requests of their own: floats, as many as there are; empty for other names.
std::vector<float> standardOption(const Options &options, std::string_view name) {
    const FrameFormat &format = options.format;
    const CameraRecord &camera = options.camera;
    const float x = float(format.xResolution), y = float(format.yResolution);
    if (name == "Format")
        return {x, y, format.pixelAspectRatio};
    if (name == "DeviceResolution") {
        const auto [xDevice, yDevice] = format.effectiveResolution();
        return {float(xDevice), float(yDevice), format.pixelAspectRatio};
    }
    if (name == "FrameAspectRatio")
        return {format.frameAspectRatio.value_or(x * format.pixelAspectRatio / y)};
    if (name == "CropWindow")
        return {format.cropWindow.begin(), format.cropWindow.end()};
    if (name == "DepthOfField")
        return {camera.fStop, camera.focalLength, camera.focalDistance};
    if (name == "Shutter")
        return {camera.shutterOpen, camera.shutterClose};
    return {};
}

} // namespace

std::vector<float> optionValue(const Options &options, std::string_view name,
                               std::string_view type) {
    if (name.starts_with("Ri:"))
        name.remove_prefix(3);
    const auto wanted = parseDeclaration(type);
    if (!wanted)
        return {};
    if (std::vector<float> values = standardOption(options, name); !values.empty()) {
        const bool fits =
            wanted->type == ValueType::Float && wanted->arraySize == int(values.size());
        return fits ? values : std::vector<float>{};
    }
    return namedValue(options.named, std::string(name), *wanted);
}

template <auto answer> void ShaderAnswers::letTexturesAnswer(Service service) {
    services_[service] = [](void *context, const ServiceCall &call) {
        (static_cast<ShaderAnswers *>(context)->textures_.*answer)(call);
    };
}

ShaderAnswers::ShaderAnswers(std::vector<std::string> textureFolders, DiagnosticSink &diagnostics)
    : diagnostics_(diagnostics), textures_(std::move(textureFolders), diagnostics) {
    services_.context = this;
    services_[Service::print] = [](void *context, const ServiceCall &call) {
        static_cast<ShaderAnswers *>(context)->print(call);
    };
    services_[Service::option] = [](void *context, const ServiceCall &call) {
        static_cast<const ShaderAnswers *>(context)->option(call);
    };
    services_[Service::transmission] = [](void *context, const ServiceCall &call) {
        static_cast<const ShaderAnswers *>(context)->transmission(call);
    };
    services_[Service::occlusion] = [](void *context, const ServiceCall &call) {
        if (const RayAnswers *rays = static_cast<const ShaderAnswers *>(context)->rays_)
            rays->occlusion(call);
    };
    services_[Service::nearestHit] = [](void *context, const ServiceCall &call) {
        if (const RayAnswers *rays = static_cast<const ShaderAnswers *>(context)->rays_)
            rays->nearestHit(call);
    };
    services_[Service::gatherlight] = [](void *, const ServiceCall &call) {
        if (VolumeLights *lights = call.args->volumeLights)
            lights->gather(call);
    };
    services_[Service::lightsample] = [](void *, const ServiceCall &call) {
        if (VolumeLights *lights = call.args->volumeLights)
            lights->sample(call);
    };
    letTexturesAnswer<&Textures::texture>(Service::texture);
    letTexturesAnswer<&Textures::texture>(Service::textureSlopes);
    letTexturesAnswer<&Textures::environment>(Service::environment);
    letTexturesAnswer<&Textures::shadow>(Service::shadow);
    letTexturesAnswer<&Textures::textureinfo>(Service::textureinfo);
    services_[Service::lightsource] = [](void *context, const ServiceCall &call) {
        static_cast<const ShaderAnswers *>(context)->lightsource(call);
    };
    silent_ = services_;
    silent_[Service::print] = [](void *, const ServiceCall &) {};
}

/// Lines of points that are shaded side by side come in any order but whole: POSIX locks the
/// stream for the time of a call.
void ShaderAnswers::print(const ServiceCall &call) {
    for (int lane = 0; lane < call.laneCount && printedBytes_ <= mostPrintedBytes; ++lane) {
        if (!call.asks(lane))
            continue;
        const std::string text = ir::printedText(call, lane);
        const std::size_t before = printedBytes_.fetch_add(text.size());
        if (before <= mostPrintedBytes)
            std::fputs(text.c_str(), stdout);
        if (before <= mostPrintedBytes && before + text.size() > mostPrintedBytes)
            diagnostics_.warning({}, "shaders have printed " + std::to_string(mostPrintedBytes) +
                                         " bytes by printf(); the rest is left out");
    }
}

void ShaderAnswers::transmission(const ServiceCall &call) const {
    if (rays_)
        return rays_->transmission(call);
    for (int lane = 0; lane < call.laneCount; ++lane)
        for (int c = 0; c < call.site->resultCount; ++c)
            call.result(c, lane) = 1;
}

int ShaderAnswers::numberOf(const std::string &text) {
    const auto [entry, isNew] = numbers_.try_emplace(text, int(strings_.size()));
    if (isNew)
        strings_.push_back(entry->first.c_str());
    services_.strings = silent_.strings = {strings_.data(), std::int32_t(strings_.size())};
    return entry->second;
}

void ShaderAnswers::bindOptions(const Options &options) {
    options_ = options;
    textures_.bind(options);
}

void ShaderAnswers::option(const ServiceCall &call) const {
    const std::vector<float> values =
        optionValue(options_, call.site->texts[0], call.site->texts[1]);
    if (int(values.size()) + 1 != call.site->resultCount)
        return;
    for (int lane = 0; lane < call.laneCount; ++lane) {
        call.result(0, lane) = 1;
        for (std::size_t k = 0; k < values.size(); ++k)
            call.result(int(k) + 1, lane) = values[k];
    }
}

namespace {

/// Which of the strings that the lane offers behind its first operand, from 1; 0 = none of them.
int offeredString(const ServiceCall &call, int lane, const std::string &wanted) {
    for (int k = 1; k < call.site->operandCount; ++k)
        if (wanted == call.string(k, lane))
            return k;
    return 0;
}

} // namespace

void ShaderAnswers::lightsource(const ServiceCall &call) const {
    const std::string_view name = call.site->texts[0], shape = call.site->texts[1];
    for (int lane = 0; lane < call.laneCount; ++lane) {
        // Light of no light source has no parameters.
        const int light = call.asks(lane) ? int(call.operand(0, lane).number) - 1 : -1;
        if (light < 0 || light >= int(lights_.size()))
            continue;
        for (const ToldParameter &parameter : lights_[std::size_t(light)]) {
            if (parameter.name != name || parameter.shape != shape)
                continue;
            call.result(0, lane) = 1;
            if (!parameter.strings.empty())
                call.result(1, lane) = float(offeredString(call, lane, parameter.strings[0]));
            for (std::size_t k = 0; k < parameter.values.size(); ++k)
                call.result(int(k) + 1, lane) = parameter.values[k];
        }
    }
}

} // namespace candela
