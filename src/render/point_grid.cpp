// SPDX-License-Identifier: Apache-2.0
#include "render/point_grid.h"

#include <algorithm>
#include <array>

namespace candela {

namespace {

/// "object" space, and what leads back: current space itself.
const std::array<float, 32> &identities() {
    static const std::array<float, 32> two = [] {
        std::array<float, 32> matrices{};
        for (std::size_t first : {0u, 16u})
            for (std::size_t i = 0; i < 4; ++i)
                matrices[first + 5 * i] = 1;
        return matrices;
    }();
    return two;
}

} // namespace

PointGrid::PointGrid(int width, int height, const QuestionCode &question)
    : width_(width), height_(height), inputs_(int(ShaderInput::Count), batchSize),
      outputs_(int(question.function.outputs.size()), batchSize), integers_(2, batchSize),
      light_(3 + colorSamples, batchSize) {
    for (int plane = 0; plane < inputs_.planes(); ++plane)
        inputTable_.push_back(inputs_[plane]);
    for (int plane = 0; plane < outputs_.planes(); ++plane)
        outputTable_.push_back(outputs_[plane]);
    for (int plane = 0; plane < light_.planes(); ++plane)
        lightTable_.push_back(light_[plane]);
    std::fill_n(light_[2], light_.lanes(), -1.0f);
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(light_[3 + c], light_.lanes(), 1.0f);
}

void PointGrid::place(sl::ShaderKind kind, std::size_t first, int count) {
    for (int i = 0; i < count; ++i) {
        const std::size_t pixel = first + std::size_t(i);
        const float x = float(pixel % std::size_t(width_)) + 0.5f;
        const float y = float(pixel / std::size_t(width_)) + 0.5f;
        const float u = x / float(width_), v = y / float(height_);
        for (ShaderInput across : {ShaderInput::u, ShaderInput::s})
            set(across, i, {u});
        for (ShaderInput down : {ShaderInput::v, ShaderInput::t})
            set(down, i, {v});
        const bool isLight = kind == sl::ShaderKind::Light;
        if (kind == sl::ShaderKind::Imager)
            set(ShaderInput::P, i, {x, y, 0});
        else
            set(isLight ? ShaderInput::Ps : ShaderInput::P, i, {2 * u - 1, 1 - 2 * v, 0});
    }
    fillWhatIsTheSame(count);
}

void PointGrid::ask(const QuestionCode &question, const ShaderInstance &instance, int count) {
    std::fill_n(integers_[0], integers_.lanes(), instance.parameterOffset);
    for (int plane = 0; plane < outputs_.planes(); ++plane)
        std::fill_n(outputs_[plane], outputs_.lanes(), 0.0f);
    ShaderArgs args;
    args.count = count;
    args.inputs = inputTable_.data();
    args.parameterOffset = integers_[0];
    args.objectIndex = integers_[1];
    args.objectMatrices = identities().data();
    args.outputs = outputTable_.data();
    args.sampleCount = 1;
    args.sampleStride = light_.lanes();
    args.sampleL = lightTable_.data();
    args.sampleCl = lightTable_.data() + 3;
    instance.code->bind(args);
    args.categoryAccepts = nullptr; // All loops hear the light.
    question.ask(args);
}

void PointGrid::set(ShaderInput input, int lane, std::initializer_list<float> values) {
    int c = 0;
    for (float value : values)
        inputs_[int(input) + c++][lane] = value;
}

void PointGrid::fill(ShaderInput input, int count, std::initializer_list<float> values) {
    int c = 0;
    for (float value : values)
        std::fill_n(inputs_[int(input) + c++], count, value);
}

void PointGrid::fillWhatIsTheSame(int count) {
    fill(ShaderInput::N, count, {0, 0, -1});
    fill(ShaderInput::Ng, count, {0, 0, -1});
    fill(ShaderInput::I, count, {0, 0, 1});
    fill(ShaderInput::Ns, count, {0, 0, -1});
    fill(ShaderInput::Is, count, {0, 0, 1});
    fill(ShaderInput::dPdu, count, {2, 0, 0});
    fill(ShaderInput::dPdv, count, {0, -2, 0});
    fill(ShaderInput::orientation, count, {1});
    fill(ShaderInput::du, count, {1 / float(width_)});
    fill(ShaderInput::dv, count, {1 / float(height_)});
    fill(ShaderInput::dsdu, count, {1});
    fill(ShaderInput::dtdv, count, {1});
    for (ShaderInput white : {ShaderInput::Cs, ShaderInput::Os, ShaderInput::pixelOi})
        fill(white, count, {1, 1, 1});
    fill(ShaderInput::pixelAlpha, count, {1});
}

} // namespace candela
