// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_code.h"

#include <algorithm>

namespace candela {

namespace {

void storeMatrices(const Matrix4 &currentFromSpace, float *to) {
    Matrix4 spaceFromCurrent = inverse(currentFromSpace).value_or(Matrix4{});
    std::ranges::copy(currentFromSpace.m, to);
    std::ranges::copy(spaceFromCurrent.m, to + 16);
}

/// The line where the text asks for a coordinate system first; 0 if that is not known.
int lineOfSpace(const ir::Region &region, int space) {
    for (const ir::Instruction &i : region.body) {
        if ((i.op == ir::Op::Space || i.op == ir::Op::SpaceInverse) && i.immediate == space)
            return i.line;
        for (const ir::Region &inner : i.regions)
            if (const int line = lineOfSpace(inner, space))
                return line;
    }
    return 0;
}

} // namespace

int QuestionCode::output(std::string_view name) const {
    for (std::size_t slot = 0; slot < function.outputs.size(); ++slot)
        if (function.outputs[slot].name == name && function.outputs[slot].component == 0)
            return int(slot);
    return -1;
}

ShaderCode::ShaderCode(ir::LoweredShader shader, ir::LightRule rule, std::shared_ptr<Jit> jit,
                       std::shared_ptr<const ShaderMessages> messages)
    : shader_(std::move(shader)), jit_(std::move(jit)), messages_(std::move(messages)) {
    if (shader_.kind == "surface") {
        shader_.whole = ir::applyLightRule(shader_.whole, rule);
        facts_ = ir::surfaceFacts(shader_.whole);
    }
}

const QuestionCode &ShaderCode::question(ir::Question which) const {
    int index = int(which);
    std::call_once(once_[index], [&] {
        QuestionCode &answer = questions_[index];
        answer.function = ir::slice(shader_.whole, which);
        answer.code = jit_->compile(answer.function);
    });
    return questions_[index];
}

std::int32_t ShaderCode::addBlock(const std::vector<float> &values) {
    std::int32_t offset = std::int32_t(blocks_.size());
    blocks_.insert(blocks_.end(), values.begin(), values.end());
    return offset;
}

void ShaderCode::bindSpaces(const std::map<std::string, Matrix4> &systems,
                            DiagnosticSink &diagnostics) {
    const std::vector<std::string> &names = shader_.whole.spaces;
    spaceMatrices_.resize(names.size());
    spaces_.clear();
    for (std::size_t i = 0; i < names.size(); ++i) {
        auto found = systems.find(names[i]);
        if (found == systems.end())
            diagnostics.warning({}, "shader \"" + name() + "\", line " +
                                        std::to_string(lineOfSpace(shader_.whole.body, int(i))) +
                                        ": asks for the coordinate system \"" + names[i] +
                                        "\", which the scene does not define: taking \"current\"");
        storeMatrices(found == systems.end() ? Matrix4{} : found->second, spaceMatrices_[i].data());
        spaces_.push_back(spaceMatrices_[i].data());
    }
}

void ShaderCode::bindCategories(std::vector<std::uint8_t> accepts, int lightCount) {
    categoryAccepts_ = std::move(accepts);
    lightCount_ = lightCount;
    const std::size_t row = std::size_t(lightCount) + 1;
    hearsAsIndirect_.assign(row, 1);
    for (std::size_t first = 0; first < categoryAccepts_.size(); first += row)
        for (std::size_t light = 0; light < row; ++light)
            hearsAsIndirect_[light] &= categoryAccepts_[first + light] == categoryAccepts_[first];
    if (std::ranges::find(hearsAsIndirect_, 0) == hearsAsIndirect_.end())
        hearsAsIndirect_.clear();
    if (std::ranges::find(categoryAccepts_, 0) == categoryAccepts_.end())
        categoryAccepts_.clear(); // What accepts everything need not be asked.
}

bool ShaderCode::hears(std::int32_t light) const {
    bool hasLoop = false;
    for (const ir::LightRequest &request : shader_.whole.requests) {
        if (request.kind != ir::LightRequest::Kind::Loop)
            continue;
        hasLoop = true;
        const std::size_t row = std::size_t(lightCount_) + 1;
        if (request.category < 0 || categoryAccepts_.empty() ||
            categoryAccepts_[request.category * row + light] != 0)
            return true;
    }
    return !hasLoop;
}

void ShaderCode::bind(ShaderArgs &args) const {
    args.parameters = blocks_.data();
    args.spaces = spaces_.data();
    args.categoryAccepts = categoryAccepts_.empty() ? nullptr : categoryAccepts_.data();
    args.lightCount = lightCount_;
    args.callbacks = &messages_->callbacks();
}

} // namespace candela
