// SPDX-License-Identifier: Apache-2.0
#include "world/scene/segments.h"

#include "foundation/base/lanes.h"

#include <algorithm>

namespace candela {

Segments::Colors Segments::colors(int first) const {
    Colors planes;
    for (int c = 0; c < colorSamples; ++c)
        planes[std::size_t(c)] = results_[first * colorSamples + c];
    return planes;
}

Segments::Segments(int capacity)
    : inputs_(int(ShaderInput::Count), capacity), results_(7 * colorSamples, capacity),
      integers_(3, capacity) {
    medium = integers_[0]; // Then the parameters' offsets, then zeros.
    answers_ = {colors(0), colors(1), colors(2), colors(3), colors(4)};
    Ci_ = colors(5), Oi_ = colors(6);
    endAnywhere(nullptr);
}

void Segments::endAt(const ShadingPoints &points, const float *objectMatrices) {
    inputTable_.assign(points.inputTable.begin(), points.inputTable.end());
    for (const auto &[first, components] : {std::pair{ShaderInput::I, 3},
                                            {ShaderInput::seed, 1},
                                            {ShaderInput::pixelCi, colorSamples},
                                            {ShaderInput::pixelOi, colorSamples}})
        for (int c = 0; c < components; ++c)
            inputTable_[std::size_t(first) + std::size_t(c)] = input(first, c);
    objectIndex_ = points.objectIndex;
    objectMatrices_ = objectMatrices;
}

void Segments::endAnywhere(const float *objectMatrices) {
    inputTable_.clear();
    for (int plane = 0; plane < inputs_.planes(); ++plane)
        inputTable_.push_back(inputs_[plane]);
    objectIndex_ = integers_[2];
    objectMatrices_ = objectMatrices;
}

std::vector<Segments::Group> Segments::begin(const Scene &scene) {
    for (int c = 0; c < colorSamples; ++c) {
        lanes::fill(count, 0.0f, answers_.Ci[c]);
        lanes::fill(count, 0.0f, answers_.Oi[c]);
        lanes::fill(count, 1.0f, answers_.CiOfCi[c]);
        lanes::fill(count, 0.0f, answers_.CiOfOi[c]);
        lanes::fill(count, 1.0f, answers_.OiOfOi[c]);
    }
    shutter_ = scene.camera().shutter();
    std::vector<Group> groups;
    std::int32_t *parameterOffset = integers_[1];
    for (int i = 0; i < count; ++i) {
        if (medium[i] == 0)
            continue;
        const ShaderInstance &shader = scene.medium(medium[i]);
        parameterOffset[i] = shader.parameterOffset;
        auto group = std::ranges::find(groups, shader.code.get(), &Group::code);
        if (group == groups.end()) {
            groups.push_back({shader.code.get(), {}});
            group = groups.end() - 1;
            group->active.assign(std::size_t(inputs_.lanes() / laneBlock), 0);
        }
        group->active[std::size_t(i / laneBlock)] |= std::uint16_t(1 << (i % laneBlock));
    }
    return groups;
}

void Segments::give(ShaderInput first, float value) {
    for (int c = 0; c < colorSamples; ++c)
        lanes::fill(count, value, input(first, c));
}

void Segments::placeParameters(const ir::Function &function) {
    const int count = int(function.outputs.size());
    if (parameters_.planes() < count)
        parameters_ = Planes<float>(count, inputs_.lanes());
    outputs_.clear();
    for (int slot = 0; slot < count; ++slot)
        outputs_.push_back(parameters_[slot]);
}

void Segments::run(const Group &group, ir::Question which, VolumeLights *lights, bool prints) {
    const QuestionCode &question = group.code->question(which);
    if (!question.code) // Reported.
        return;
    placeParameters(question.function);
    const bool whole = which == ir::Question::Volume;
    question.place(ir::OutputKind::Ci, whole ? Ci_.data() : answers_.Ci.data(), outputs_);
    question.place(ir::OutputKind::Oi, whole ? Oi_.data() : answers_.Oi.data(), outputs_);
    question.place(ir::OutputKind::CiOfCi, answers_.CiOfCi.data(), outputs_);
    question.place(ir::OutputKind::CiOfOi, answers_.CiOfOi.data(), outputs_);
    question.place(ir::OutputKind::OiOfOi, answers_.OiOfOi.data(), outputs_);
    ShaderArgs args;
    args.count = count;
    args.active = group.active.data();
    args.inputs = inputTable_.data();
    args.parameterOffset = integers_[1];
    args.objectIndex = objectIndex_;
    args.objectMatrices = objectMatrices_;
    args.outputs = outputs_.data();
    args.volumeLights = lights;
    args.ambient = ambient;
    group.code->bind(args, prints);
    moving_.take(*group.code, shutter_, count, integers_[1],
                 inputTable_[std::size_t(ShaderInput::time)], group.active.data());
    moving_.bind(args);
    question.code(&args);
}

void Segments::ask(const Group &group, VolumeLights *lights, bool prints) {
    if (group.code->volumeFacts().affine)
        run(group, ir::Question::Segment, lights, prints);
    else
        askWhole(group, lights, prints);
}

void Segments::askTransmission(const Group &group) {
    if (group.code->volumeFacts().affine)
        run(group, ir::Question::Transmission, nullptr, false);
    else
        askWhole(group, nullptr, false);
}

void Segments::runWhole(const Group &group, float Ci, float Oi, VolumeLights *lights, bool prints) {
    give(ShaderInput::pixelCi, Ci);
    give(ShaderInput::pixelOi, Oi);
    run(group, ir::Question::Volume, lights, prints);
}

void Segments::askWhole(const Group &group, VolumeLights *lights, bool prints) {
    const auto forActive = [&](auto &&visit) {
        for (int i = 0; i < count; ++i)
            if (group.active[std::size_t(i / laneBlock)] >> (i % laneBlock) & 1)
                for (std::size_t c = 0; c < colorSamples; ++c)
                    visit(i, c);
    };
    runWhole(group, 1, 0, lights, false);
    forActive([&](int i, std::size_t c) { answers_.CiOfCi[c][i] = Ci_[c][i]; });
    runWhole(group, 0, 1, lights, false);
    forActive([&](int i, std::size_t c) {
        answers_.CiOfOi[c][i] = Ci_[c][i], answers_.OiOfOi[c][i] = Oi_[c][i];
    });
    runWhole(group, 0, 0, lights, prints);
    forActive([&](int i, std::size_t c) {
        answers_.Ci[c][i] = Ci_[c][i], answers_.Oi[c][i] = Oi_[c][i];
        answers_.CiOfCi[c][i] -= Ci_[c][i], answers_.CiOfOi[c][i] -= Ci_[c][i];
        answers_.OiOfOi[c][i] -= Oi_[c][i];
    });
}

} // namespace candela
