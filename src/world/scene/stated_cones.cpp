// SPDX-License-Identifier: Apache-2.0
#include "world/scene/stated_cones.h"

#include "world/scene/light_question.h"
#include "world/scene/scene_state.h"

namespace candela {

std::optional<StatedCones> statedCones(const SceneState &state, const SceneLight &light) {
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
    StatedCones stated;
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

} // namespace candela
