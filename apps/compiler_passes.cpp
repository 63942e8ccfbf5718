// SPDX-License-Identifier: Apache-2.0
#include "apps/compiler_passes.h"

#include "language/ir/analyse/control_relevance.h"
#include "language/ir/filter/pixel_loops.h"
#include "language/ir/lower/lower.h"
#include "language/ir/questions/plan.h"
#include "language/ir/transform/fold.h"
#include "world/shading/instance_values.h"

namespace candela {

namespace {

/// What decides control flow folded in, as an instance with all defaults has it; of filters all.
ir::Function withDefaults(const ir::LoweredShader &lowered, DiagnosticSink &diagnostics) {
    const std::vector<float> block =
        parameterBlock(lowered, ShaderRecord(), Options(), {}, diagnostics);
    if (sl::runsFor(lowered.kind) == sl::RunsFor::Picture)
        return ir::foldAll(lowered.whole, block);
    std::vector<ir::FoldedValue> folded;
    for (const int slot : ir::controlRelevantParameters(lowered.whole))
        folded.push_back({slot, block[size_t(slot)]});
    return ir::fold(lowered.whole, folded);
}

} // namespace

std::optional<CompiledShader> compileShader(const sl::TypedShader &shader, ir::LightRule rule,
                                            const ir::PassListener &listener,
                                            DiagnosticSink &diagnostics) {
    ir::LoweringOptions lowering;
    lowering.listener = listener;
    const auto lowered = ir::lower(shader, {}, {}, diagnostics, lowering);
    if (!lowered)
        return std::nullopt;
    ir::Function whole = withDefaults(*lowered, diagnostics);
    listener("fold", whole);

    CompiledShader compiled;
    compiled.parameters = lowered->parameters;
    compiled.inverseSquare = lowered->inverseSquare;
    for (const sl::Parameter &parameter : shader.parameters)
        compiled.parameterDocs.push_back(parameter.doc);
    std::shared_ptr<const ir::Plan> plan;
    if (ir::isPlanned(lowered->kind)) {
        whole = ir::applyLightRule(whole, rule);
        listener("light rule", whole);
        plan = ir::makePlan(whole);
        listener("plan", plan->text);
        compiled.facts = ir::surfaceFacts(*plan);
        compiled.bounds = ir::boundFacts(*plan);
    } else if (lowered->kind == sl::ShaderKind::Light) {
        compiled.lightFacts = ir::lightFacts(whole);
        compiled.bounds = ir::lightBoundFacts(whole);
    } else if (lowered->kind == sl::ShaderKind::Volume) {
        compiled.volumeFacts = ir::volumeFacts(whole);
    }
    compiled.displacement = ir::displacementFacts(whole);
    std::vector<ir::Question> questions = ir::questionsOf(lowered->kind);
    const std::size_t ownQuestions = questions.size();
    if (lowered->kind == sl::ShaderKind::Surface && compiled.displacement.movesP)
        questions.insert(questions.end(), {ir::Question::Displaced, ir::Question::Displace});
    for (std::size_t k = 0; k < questions.size(); ++k) {
        const ir::Question question = questions[k];
        ir::Function answer =
            plan && k < ownQuestions ? ir::slice(*plan, question) : ir::slice(whole, question);
        if (question == ir::Question::Filter)
            answer = ir::extractPixelLoops(std::move(answer));
        compiled.answers.push_back({question, std::move(answer)});
        listener(ir::nameOf(question), compiled.answers.back().function);
    }
    return compiled;
}

} // namespace candela
