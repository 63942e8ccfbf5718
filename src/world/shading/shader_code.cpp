// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_code.h"
#include "language/ir/transform/light_rule.h"

namespace candela {

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
    categories_ = LightCategories(shader_.whole.requests);
}

const QuestionCode &ShaderCode::question(ir::Question which) const {
    CompiledQuestion &compiled = questions_[int(which)];
    std::call_once(compiled.once, [&] {
        compiled.answer.function = ir::slice(shader_.whole, which);
        compiled.answer.code = jit_->compile(compiled.answer.function);
    });
    return compiled.answer;
}

std::int32_t ShaderCode::addBlock(const std::vector<float> &values) {
    std::int32_t offset = std::int32_t(blocks_.size());
    blocks_.insert(blocks_.end(), values.begin(), values.end());
    return offset;
}

void ShaderCode::bindSpaces(const std::map<std::string, Matrix4> &systems,
                            DiagnosticSink &diagnostics) {
    spaces_.bind(shader_.whole, name(), systems, diagnostics);
}

void ShaderCode::bindCategories(std::vector<std::uint8_t> accepts, int lightCount) {
    categories_.bind(std::move(accepts), lightCount);
}

void ShaderCode::bind(ShaderArgs &args) const {
    args.parameters = blocks_.data();
    args.spaces = spaces_.data();
    categories_.bind(args);
    args.callbacks = &messages_->callbacks();
}

} // namespace candela
