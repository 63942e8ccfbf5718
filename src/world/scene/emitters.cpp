// SPDX-License-Identifier: Apache-2.0
#include "world/scene/emitters.h"

#include "world/scene/light_question.h"
#include "world/scene/scene_state.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace candela {

namespace {

/// Where the light shader says that it stands and sends.
struct StatedEmission {
    Vec3 place;
    std::vector<EmissionCone> cones;
};

/// Asks a shader whose cones are its light's own; nothing if it states none, or from several
/// places.
std::optional<StatedEmission> statedEmission(const SceneState &state, const SceneLight &light) {
    const ShaderCode &code = *light.shader.code;
    const ir::LightFacts facts = ir::lightFacts(code.shader().whole);
    if (facts.cones.empty() || !facts.conesAreTheLights)
        return std::nullopt;
    const QuestionCode &question = code.question(ir::Question::Emission);
    if (question.reads(ShaderInput::N) || question.reads(ShaderInput::Ng))
        return std::nullopt; // Those of what is lit.
    LightBatch batch(1);
    batch.count = 1;
    placePointLight(batch, 0, light, state.points.shutter);
    batch.parameterOffset[0] = light.shader.parameterOffset;
    batch.objectIndex[0] = 0;
    Planes<float> answers(int(question.function.outputs.size()), 1);
    std::vector<float *> outputs;
    for (int plane = 0; plane < answers.planes(); ++plane)
        outputs.push_back(answers[plane]);
    ShaderArgs args;
    args.count = 1;
    args.inputs = batch.inputTable.data();
    args.parameterOffset = batch.parameterOffset;
    args.objectMatrices = state.points.shapeMatrices.data();
    args.objectIndex = batch.objectIndex;
    args.outputs = outputs.data();
    code.bind(args, false);
    question.ask(args);

    const auto vec3 = [&](int plane) {
        return Vec3{answers[plane][0], answers[plane + 1][0], answers[plane + 2][0]};
    };
    StatedEmission stated;
    for (const ir::ConeSlot &slot : facts.cones) {
        const EmissionCone cone{normalize(vec3(slot.axis)), answers[slot.angle][0],
                                answers[slot.exponent][0], answers[slot.importance][0]};
        if (!(cone.importance > 0))
            continue;
        const Vec3 place = vec3(slot.position);
        if (!isFinite(place) || !isFinite(cone.axis))
            return std::nullopt;
        if (!stated.cones.empty() && !(place == stated.place))
            return std::nullopt;
        stated.place = place;
        stated.cones.push_back(cone);
    }
    if (stated.cones.empty())
        return std::nullopt;
    return stated;
}

/// All surfaces hear the light as they hear light from elsewhere.
bool isHeardAlike(const SceneState &state, std::int32_t light) {
    return std::ranges::all_of(state.points.codes, [&](const SurfaceCode &code) {
        return code.code->categories().hearsAsIndirect(light + 1);
    });
}

/// A whole sphere around all that the scene holds: few of its paths would meet anything.
bool surroundsScene(const SceneState &state, const SceneLight &light) {
    const LightTable &table = state.lights;
    if (light.sources != 1)
        return false;
    const LightElement &element = table.firstElementOf(table.sources[light.firstSource]);
    return element.form == LightElement::Form::Sphere && element.edgeA.x > state.radius * 0.5f;
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
        const std::optional<StatedEmission> stated = statedEmission(state, light);
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
