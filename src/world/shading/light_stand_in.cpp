// SPDX-License-Identifier: Apache-2.0
#include "world/shading/light_stand_in.h"

#include "foundation/base/letters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>

namespace candela {

namespace {

struct StandIn {
    const char *shader;
    std::array<const char *, 6> parameters; ///< Null: no more.
};
constexpr StandIn ambient{"ambientlight", {"intensity", "lightcolor"}};
constexpr StandIn distant{"distantlight", {"intensity", "lightcolor", "from", "to"}};
constexpr StandIn spot{"spotlight",
                       {"intensity", "lightcolor", "from", "to", "coneangle", "conedeltaangle"}};
constexpr StandIn point{"pointlight", {"intensity", "lightcolor", "from"}};
constexpr StandIn alike{"pointnofalloff", {"intensity", "lightcolor", "from"}};

StandIn choose(const ShaderRecord &record) {
    const std::string name = inSmallLetters(record.name);
    const auto isCalled = [&](std::initializer_list<const char *> words) {
        return std::ranges::any_of(
            words, [&](const char *word) { return name.find(word) != std::string::npos; });
    };
    const auto has = [&](const char *parameter) {
        return record.parameters.find(parameter) != nullptr;
    };
    if (isCalled({"ambient", "env", "dome", "sky", "occlusion"}))
        return ambient;
    if (has("coneangle") || (isCalled({"spot"}) && has("from")))
        return spot;
    if (isCalled({"nofall", "nodecay"}))
        return alike;
    if (isCalled({"point"}) && has("from"))
        return point;
    if (isCalled({"distant", "solar", "sun", "parallel"}) || has("to"))
        return distant;
    return alike;
}

/// Of the light's parameters; what is not given, or no such number, counts as `otherwise`.
float numberOf(const ShaderRecord &record, const char *name, float otherwise) {
    const Parameter *given = record.parameters.find(name);
    return given && given->floats.size() == 1 ? given->floats[0] : otherwise;
}

LightRecord areaStandIn(const LightRecord &light) {
    LightRecord result = light;
    result.units = LightUnits::Si, result.shadows = true;
    result.shader.name = "arealight";
    result.shader.motion = nullptr;
    std::vector<Parameter> &parameters = result.shader.parameters.all;
    parameters.clear();
    const float radiance =
        numberOf(light.shader, "intensity", 1) * std::exp2(numberOf(light.shader, "exposure", 0));
    parameters.push_back(
        {"radiance", {StorageClass::Uniform, ValueType::Float, 1}, {radiance}, {}});
    for (const char *name : {"lightcolor", "lightColor"})
        if (const Parameter *given = light.shader.parameters.find(name);
            given && given->floats.size() == colorSamples)
            parameters.push_back(
                {"lightcolor", {StorageClass::Uniform, ValueType::Color, 1}, given->floats, {}});
    return result;
}

} // namespace

LightRecord lightStandIn(const LightRecord &light) {
    if (light.area)
        return areaStandIn(light);
    const StandIn standIn = choose(light.shader);
    LightRecord result = light;
    result.shader.name = standIn.shader;
    result.shader.motion = nullptr;
    std::erase_if(result.shader.parameters.all, [&](const Parameter &parameter) {
        return std::ranges::none_of(standIn.parameters, [&](const char *known) {
            return known && parameter.name == known;
        });
    });
    return result;
}

} // namespace candela
