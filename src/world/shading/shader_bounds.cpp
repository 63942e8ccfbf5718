// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_bounds.h"

#include <algorithm>

namespace candela {

namespace {

struct Quantity {
    ir::OutputKind value, byU, byV, tolerance;
};
constexpr Quantity ofLights{ir::OutputKind::Cl, ir::OutputKind::ClByU, ir::OutputKind::ClByV,
                            ir::OutputKind::ClTolerance};
constexpr std::size_t emissionPlace = 1;
constexpr Quantity quantities[] = {
    {ir::OutputKind::Reflectance, ir::OutputKind::ReflectanceByU, ir::OutputKind::ReflectanceByV,
     ir::OutputKind::ReflectanceTolerance},
    {ir::OutputKind::Ce, ir::OutputKind::CeByU, ir::OutputKind::CeByV, ir::OutputKind::CeTolerance},
    {ir::OutputKind::Oi, ir::OutputKind::OiByU, ir::OutputKind::OiByV,
     ir::OutputKind::OiTolerance}};

} // namespace

BoxBounds::BoxBounds(const ShaderInstance &instance, int mostBoxes)
    : instance_(instance), inputs_(int(ShaderInput::Count), mostBoxes),
      outputs_(4 * colorSamples * int(std::size(quantities)), mostBoxes), integers_(2, mostBoxes),
      unwanted_(1, mostBoxes) {
    for (std::size_t first : {0u, 16u})
        for (std::size_t i = 0; i < 4; ++i)
            object_[first + 5 * i] = 1;
    for (int plane = 0; plane < inputs_.planes(); ++plane)
        inputTable_.push_back(inputs_[plane]);
    std::fill_n(integers_[0], integers_.lanes(), instance.parameterOffset);
    using ir::Question;
    const bool isLight = instance.code->shader().kind == sl::ShaderKind::Light;
    boundsCode_ = &instance.code->question(isLight ? Question::LightBounds : Question::Bounds);
    valuesCode_ = &instance.code->question(isLight ? Question::Light : Question::Furnace);
    int next = 0;
    const auto place = [&](ir::OutputKind kind, std::array<const float *, colorSamples> &shown) {
        std::array<float *, colorSamples> planes;
        for (int c = 0; c < colorSamples; ++c)
            shown[std::size_t(c)] = planes[std::size_t(c)] = outputs_[next++];
        boundsCode_->place(kind, planes.data(), bounds_);
        valuesCode_->place(kind, planes.data(), values_);
    };
    for (std::size_t q = 0; q < planes_.size(); ++q) {
        const Quantity &quantity = isLight && q == emissionPlace ? ofLights : quantities[q];
        place(quantity.value, planes_[q].value);
        place(quantity.byU, planes_[q].byU);
        place(quantity.byV, planes_[q].byV);
        place(quantity.tolerance, planes_[q].tolerance);
    }
    for (std::vector<float *> *outputs : {&bounds_, &values_}) // A light's L.
        std::ranges::replace(*outputs, nullptr, unwanted_[0]);
}

void BoxBounds::set(ShaderInput input, int box, std::initializer_list<float> components) {
    int plane = int(input);
    for (float component : components)
        inputs_[plane++][box] = component;
}

void BoxBounds::setObject(const float *twoMatrices) {
    std::copy_n(twoMatrices, object_.size(), object_.begin());
}

void BoxBounds::ask(int count) { ask(*boundsCode_, bounds_, count); }

void BoxBounds::askValues(int count) { ask(*valuesCode_, values_, count); }

void BoxBounds::ask(const QuestionCode &question, const std::vector<float *> &outputs, int count) {
    ShaderArgs args;
    args.count = count;
    args.inputs = inputTable_.data();
    args.parameterOffset = integers_[0];
    args.objectIndex = integers_[1];
    args.objectMatrices = object_.data();
    args.outputs = outputs.data();
    instance_.code->bind(args, false);
    question.ask(args);
}

} // namespace candela
