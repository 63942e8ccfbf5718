// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_question.h"

#include "foundation/base/hash.h"

#include <algorithm>
#include <array>
#include <bit>

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

bool readsWhatIsLit(const ShaderCode &code, bool hasSurface) {
    const auto reads = [&](ShaderInput first) {
        return std::ranges::any_of(std::array{0, 1, 2}, [&](int component) {
            return code.reads(ShaderInput(int(first) + component));
        });
    };
    return reads(ShaderInput::Ns) || reads(ShaderInput::Is) ||
           (!hasSurface && (reads(ShaderInput::N) || reads(ShaderInput::Ng)));
}

/// Where no surface asks, Ns leads to the light. Where nobody looks, a surface is seen straight on,
/// and all else from the eye.
void LightBatch::tellWhoAsks(const ShaderCode &code) {
    if (!readsWhatIsLit(code, hasSurface))
        return;
    const auto vector = [&](ShaderInput first, int lane) {
        const float *const *planes = inputTable.data() + int(first);
        return Vec3{planes[0][lane], planes[1][lane], planes[2][lane]};
    };
    const bool isSurface = Ns[0] != nullptr, isSeen = I[0] != nullptr;
    for (int lane = 0; lane < count; ++lane) {
        const Vec3 P = vector(ShaderInput::P, lane), lit = vector(ShaderInput::Ps, lane);
        const Vec3 normal =
            isSurface ? Vec3{Ns[0][lane], Ns[1][lane], Ns[2][lane]} : normalize(P - lit);
        const Vec3 way = isSeen      ? Vec3{I[0][lane], I[1][lane], I[2][lane]}
                         : isSurface ? normal * -1.0f
                                     : lit;
        for (int c = 0; c < 3; ++c) {
            input(ShaderInput::Ns, c)[lane] = normal[c];
            input(ShaderInput::Is, c)[lane] = way[c];
        }
    }
    float *const told[3] = {input(ShaderInput::Ns, 0), input(ShaderInput::Ns, 1),
                            input(ShaderInput::Ns, 2)};
    float *const seen[3] = {input(ShaderInput::Is, 0), input(ShaderInput::Is, 1),
                            input(ShaderInput::Is, 2)};
    readFrom(ShaderInput::Ns, 3, told);
    readFrom(ShaderInput::Is, 3, seen);
    if (hasSurface)
        return;
    readFrom(ShaderInput::N, 3, told);
    readFrom(ShaderInput::Ng, 3, told);
}

/// random(), and the rays of occlusion(), are others for each point that is lit and each sample.
void LightBatch::drawSeeds(const ShaderCode &code) {
    if (!code.reads(ShaderInput::seed))
        return;
    const int told[] = {
        int(ShaderInput::Ps),   int(ShaderInput::Ps) + 1,      int(ShaderInput::Ps) + 2,
        int(ShaderInput::P),    int(ShaderInput::P) + 1,       int(ShaderInput::P) + 2,
        int(ShaderInput::time), int(ShaderInput::lightSample), int(ShaderInput::lightSample) + 1};
    float *const seed = input(ShaderInput::seed);
    for (int lane = 0; lane < count; ++lane) {
        std::uint64_t bits = 0;
        for (int plane : told)
            bits = mixBits(bits ^ std::bit_cast<std::uint32_t>(inputTable[plane][lane]));
        seed[lane] = std::bit_cast<float>(std::uint32_t(bits >> 32));
    }
    readFrom(ShaderInput::seed, 1, nullptr);
}

void LightBatch::ask(const SceneState &state, const ShaderCode &code, const std::uint16_t *active) {
    tellWhoAsks(code);
    drawSeeds(code);
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
    const Vec3 origin = transformPoint(currentFromShader, {0, 0, 0});
    for (int c = 0; c < 3; ++c)
        batch.input(ShaderInput::P, c)[lane] = origin[c];
}

} // namespace candela
