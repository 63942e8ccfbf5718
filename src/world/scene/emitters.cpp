// SPDX-License-Identifier: Apache-2.0
#include "world/scene/emitters.h"

#include "world/scene/scene_state.h"
#include "world/scene/stated_cones.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace candela {

namespace {

/// All surfaces hear the light as they hear light from elsewhere.
bool isHeardAlike(const SceneState &state, std::int32_t light) {
    return std::ranges::all_of(state.points.codes, [&](const SurfaceCode &code) {
        return code.code->categories().hearsAsIndirect(light + 1);
    });
}

/// A whole sphere around all that the scene holds, its own box: few of its paths would meet
/// anything.
bool surroundsScene(const SceneState &state, const SceneLight &light) {
    constexpr float rounding = 1e-3f;
    const LightTable &table = state.lights;
    if (light.sources != 1)
        return false;
    const LightElement &element = table.firstElementOf(table.sources[light.firstSource]);
    if (element.form != LightElement::Form::Sphere)
        return false;
    const float reach = element.edgeA.x * (1 + rounding);
    for (int c = 0; c < 3; ++c)
        if (state.bound.low[c] < element.corner[c] - reach ||
            state.bound.high[c] > element.corner[c] + reach)
            return false;
    return true;
}

/// Why no path begins at the light; empty if it can.
std::string describe(const SceneState &state, int index, Emitter &emitter) {
    const SceneLight &light = state.lights.lights[index];
    if (!light.si)
        return "it has classic units";
    if (!light.castsShadow)
        return "it shines through what stands in its way";
    if (!isHeardAlike(state, index))
        return "surfaces hear it by its category";
    if (light.kind == LightKind::Distant) {
        emitter.form = EmitterForm::Distant;
        emitter.shows = false;
        return {};
    }
    if (light.kind == LightKind::Point) {
        const std::optional<StatedCones> stated = statedCones(state, light);
        if (!stated)
            return "where it stands depends on what it lights";
        emitter.form = EmitterForm::Point;
        emitter.place = stated->place, emitter.lobes = EmissionLobes(stated->cones);
        emitter.shows = false;
        return {};
    }
    if (surroundsScene(state, light))
        return "it surrounds the scene";
    emitter.form = EmitterForm::Surface;
    emitter.area = light.area, emitter.sides = light.sides;
    return {};
}

} // namespace

Emitters findEmitters(const SceneState &state, std::vector<std::string> &silent) {
    const std::vector<SceneLight> &lights = state.lights.lights;
    Emitters emitters;
    emitters.lights.resize(lights.size());
    emitters.discArea = std::numbers::pi * double(state.radius) * state.radius;
    std::vector<double> power(lights.size());
    double total = 0;
    for (int k = 0; k < int(lights.size()); ++k) {
        if (!lights[k].isSampled() || !(lights[k].power > 0))
            continue;
        const std::string reason = describe(state, k, emitters.lights[k]);
        if (!reason.empty())
            silent.push_back("light shader \"" + lights[k].shader.code->name() + "\": " + reason);
        else
            total += power[k] = lights[k].power;
    }
    double sum = 0;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        emitters.lights[k].probability = total > 0 ? power[k] / total : 0;
        emitters.cumulative.push_back(sum += emitters.lights[k].probability);
    }
    return emitters;
}

} // namespace candela
