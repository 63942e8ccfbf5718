// SPDX-License-Identifier: Apache-2.0
#include "world/shading/light_stand_in.h"

#include "foundation/base/letters.h"

#include <algorithm>
#include <array>
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

} // namespace

ShaderRecord lightStandIn(const ShaderRecord &record) {
    const StandIn standIn = choose(record);
    ShaderRecord result = record;
    result.name = standIn.shader;
    result.motion = nullptr;
    std::erase_if(result.parameters.all, [&](const Parameter &parameter) {
        return std::ranges::none_of(standIn.parameters, [&](const char *known) {
            return known && parameter.name == known;
        });
    });
    return result;
}

} // namespace candela
