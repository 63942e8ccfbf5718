// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_answers.h"

#include "interface/ri/declarations.h"
#include "language/ir/core/print_format.h"
#include "language/runtime/shader_abi.h"

#include "world/shading/volume_lights.h"

#include <algorithm>
#include <cstdio>

namespace candela {

namespace {

/// Lines of points that are shaded side by side come in any order but whole: POSIX locks the
/// stream for the time of a call.
void print(void *, const ServiceCall &call) {
    for (int lane = 0; lane < call.laneCount; ++lane)
        if (call.asks(lane))
            std::fputs(ir::printedText(call, lane).c_str(), stdout);
}

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
    const Parameter *given = options.named.find(std::string(name));
    if (!given)
        return {};
    const ValueType is = given->declaration.type;
    const bool fits = (is == ValueType::Integer ? ValueType::Float : is) == wanted->type &&
                      given->declaration.arraySize == wanted->arraySize;
    return fits ? given->floats : std::vector<float>{};
}

ShaderAnswers::ShaderAnswers() {
    services_.context = this;
    services_[Service::print] = print;
    services_[Service::option] = [](void *context, const ServiceCall &call) {
        static_cast<const ShaderAnswers *>(context)->option(call);
    };
    services_[Service::gatherlight] = [](void *, const ServiceCall &call) {
        if (VolumeLights *lights = call.args->volumeLights)
            lights->gather(call);
    };
    services_[Service::lightsample] = [](void *, const ServiceCall &call) {
        if (VolumeLights *lights = call.args->volumeLights)
            lights->sample(call);
    };
    services_[Service::lightsource] = [](void *context, const ServiceCall &call) {
        static_cast<const ShaderAnswers *>(context)->lightsource(call);
    };
    silent_ = services_;
    silent_[Service::print] = [](void *, const ServiceCall &) {};
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
