// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_code.h"

#include "language/ir/transform/fuse.h"
#include "language/ir/transform/light_rule.h"

#include <algorithm>

namespace candela {

ShaderCode::ShaderCode(ir::LoweredShader shader, ir::LightRule rule, std::shared_ptr<Jit> jit,
                       std::shared_ptr<const ShaderMessages> messages,
                       std::shared_ptr<const ShaderAnswers> answers)
    : shader_(std::move(shader)), rule_(rule), jit_(std::move(jit)), messages_(std::move(messages)),
      answers_(std::move(answers)) {
    readText();
}

void ShaderCode::readText() {
    displacement_ = ir::displacementFacts(shader_.whole);
    if (ir::isPlanned(shader_.kind)) {
        shader_.whole = ir::applyLightRule(shader_.whole, rule_);
        plan_ = ir::makePlan(shader_.whole);
        facts_ = ir::surfaceFacts(*plan_);
    }
    if (shader_.kind == sl::ShaderKind::Volume)
        volumeFacts_ = ir::volumeFacts(shader_.whole);
    categories_ = LightCategories(shader_.whole.requests);
}

ir::Function ShaderCode::slice(ir::Question which) const {
    ir::Function function = answering(which);
    if (jit_->fusesProducts() && ir::mayFuse(which))
        ir::fuseProducts(function);
    return function;
}

/// A point speaks once. Under the classic rule all its light is there when it is shaded; else it
/// comes direction by direction, and what the point says it says without.
ir::Function ShaderCode::answering(ir::Question which) const {
    if (!plan_ || which == ir::Question::Displace || which == ir::Question::Displaced)
        return ir::slice(shader_.whole, which);
    ir::Function function = ir::slice(*plan_, which);
    const bool shaded = which == ir::Question::Shade, lit = rule_ == ir::LightRule::Classic;
    return shaded == lit ? function : ir::silenced(std::move(function));
}

const QuestionCode &ShaderCode::question(ir::Question which) const {
    CompiledQuestion &compiled = questions_[int(which)];
    std::call_once(compiled.once, [&] {
        compiled.answer.function = slice(which);
        compiled.answer.code = jit_->compile(compiled.answer.function);
    });
    return compiled.answer;
}

/// As the stages of integrators ask them (light/path/stages.h).
std::vector<ir::Question> ShaderCode::questionsAsked() const {
    using ir::Question;
    if (shader_.kind == sl::ShaderKind::Volume && volumeFacts_.affine)
        return {Question::Segment, Question::Transmission};
    std::vector<Question> asked;
    if (displacement_.movesP)
        asked.push_back(Question::Displace);
    if (displacement_.movesP || displacement_.setsN)
        asked.push_back(Question::Displaced);
    if (shader_.kind == sl::ShaderKind::Displacement ||
        shader_.kind == sl::ShaderKind::Transformation)
        return asked;
    if (!plan_)
        return {ir::questionsOf(shader_.kind).front()};
    asked.insert(asked.end(), {Question::Prepare, Question::Scatter, Question::Opacity});
    const bool classic = rule_ == ir::LightRule::Classic;
    if (classic || !facts_.affine)
        asked.push_back(Question::Shade);
    if (!classic && facts_.emits)
        asked.push_back(Question::Emit);
    return asked;
}

bool ShaderCode::compileAll(DiagnosticSink &diagnostics) {
    const std::vector<ir::Question> asked = questionsAsked();
    if (asked.empty())
        return true;
    std::vector<QuestionCode> answers(asked.size());
    std::vector<const ir::Function *> functions;
    for (std::size_t k = 0; k < asked.size(); ++k) {
        answers[k].function = slice(asked[k]);
        functions.push_back(&answers[k].function);
    }
    const std::vector<ShaderFunction> codes = jit_->compile(functions, diagnostics);
    if (std::ranges::count(codes, nullptr) > 0)
        return false;
    for (std::size_t k = 0; k < asked.size(); ++k) {
        CompiledQuestion &compiled = questions_[int(asked[k])];
        std::call_once(compiled.once, [&] {
            compiled.answer = std::move(answers[k]);
            compiled.answer.code = codes[k];
        });
    }
    return true;
}

void ShaderCode::become(ir::LoweredShader other) {
    other.name = shader_.name; // Messages are about the shader that the user knows.
    shader_ = std::move(other);
    isStandIn_ = true;
    readText();
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

void ShaderCode::bind(ShaderArgs &args, bool prints) const {
    args.parameters = blocks_.data();
    args.spaces = spaces_.data();
    categories_.bind(args);
    args.callbacks = &messages_->callbacks();
    args.services = &answers_->services(prints);
}

} // namespace candela
