// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_question.h"

#include <algorithm>

namespace candela {

LightBatch::LightBatch(int capacity)
    : inputs(int(ShaderInput::Count), capacity), answers(4 + colorSamples, capacity),
      integers(2, capacity) {
    for (int plane = 0; plane < int(ShaderInput::Count); ++plane)
        inputTable.push_back(inputs[plane]);
    std::fill_n(input(ShaderInput::rayOffset), capacity, 0.0f);
    parameterOffset = integers[0], objectIndex = integers[1];
    for (int c = 0; c < 3; ++c)
        L[c] = answers[c];
    for (int c = 0; c < colorSamples; ++c)
        Cl[c] = answers[3 + c];
}

void LightBatch::readFrom(ShaderInput which, int components, const float *const *planes) {
    for (int c = 0; c < components; ++c)
        inputTable[int(which) + c] = planes ? planes[c] : inputs[int(which) + c];
}

void LightBatch::ask(const SceneState &state, const ShaderCode &code, const std::uint16_t *active) {
    for (int plane = 0; plane < answers.planes(); ++plane)
        std::fill_n(answers[plane], count, 0.0f);
    const QuestionCode &question = code.question(ir::Question::Light);
    if (!question.code)
        return;
    thread_local std::vector<float *> outputs;
    // The shader's output parameters go where nobody looks.
    outputs.assign(question.function.outputs.size(), answers[3 + colorSamples]);
    question.place(ir::OutputKind::L, L.data(), outputs);
    question.place(ir::OutputKind::Cl, Cl.data(), outputs);
    ShaderArgs args;
    args.count = count;
    args.active = active;
    args.inputs = inputTable.data();
    args.parameterOffset = parameterOffset;
    args.objectMatrices = state.points.shapeMatrices.data();
    args.objectIndex = objectIndex;
    args.outputs = outputs.data();
    code.bind(args, prints);
    parameters.take(code, state.points.shutter, count, parameterOffset,
                    inputTable[int(ShaderInput::time)], active);
    parameters.bind(args);
    question.code(&args);
}

void placePointLight(LightBatch &batch, int lane, const SceneLight &light, const Shutter &shutter) {
    const Matrix4 currentFromShader =
        light.steps.empty()
            ? light.currentFromShader
            : matrixAt(light.steps, shutter.share(batch.input(ShaderInput::time)[lane]));
    Vec3 axis = normalize(transformVector(currentFromShader, {0, 0, 1}));
    Vec3 origin = transformPoint(currentFromShader, {0, 0, 0});
    for (int c = 0; c < 3; ++c) {
        batch.input(ShaderInput::P, c)[lane] = origin[c];
        batch.input(ShaderInput::N, c)[lane] = batch.input(ShaderInput::Ng, c)[lane] = axis[c];
    }
}

} // namespace candela
