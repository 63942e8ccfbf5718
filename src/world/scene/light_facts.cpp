// SPDX-License-Identifier: Apache-2.0
// What messages tell of lights.
#include "world/scene/scene_state.h"

#include <algorithm>
#include <numbers>

namespace candela {

/// For some shape but its own; or there are no others.
static bool isOnForOthers(const SceneState &state, int light) {
    const PointTables &points = state.points;
    bool areOthers = false;
    for (std::size_t i = 0; i < points.appearances.size(); ++i) {
        const auto &lamp = points.details[i].attributes->areaLight;
        if (lamp && lamp->index == light)
            continue;
        if (state.lights.on(points.appearances[i].lightSet, light + 1))
            return true;
        areOthers = true;
    }
    return !areOthers;
}

static double surfaceShareOf(const SceneLight &light) {
    const double power = light.surfaceRadiance * colorSamples * light.area * 2 * std::numbers::pi;
    return light.power > 0 ? std::min(1.0, power / light.power) : 0;
}

LightFacts Lights::facts(int index) const {
    const SceneLight &light = state_->lights.lights[index];
    return {light.title,
            light.where,
            light.kind != LightKind::None,
            light.kind == LightKind::None && light.shader.code != nullptr,
            isOnForOthers(*state_, index),
            light.isTurnedOff,
            light.kind == LightKind::Ambient,
            light.kind == LightKind::Emitter,
            light.castsShadow,
            light.looksUpShadows,
            light.surfaceRadiance,
            surfaceShareOf(light)};
}

} // namespace candela
