// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/affine.h"
#include "language/ir/analyse/opacity.h"
#include "language/ir/questions/plan.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/dead_code.h"

namespace candela::ir {

const char *nameOf(Question question) {
    constexpr const char *names[] = {
#define QUESTION(name, text, kind, meaning) text,
#include "language/ir/questions/questions.def"
#undef QUESTION
    };
    return names[int(question)];
}

std::vector<Question> questionsOf(sl::ShaderKind kind) {
    constexpr sl::ShaderKind kinds[] = {
#define QUESTION(name, text, kind, meaning) sl::ShaderKind::kind,
#include "language/ir/questions/questions.def"
#undef QUESTION
    };
    std::vector<Question> questions;
    for (int q = 0; q < questionCount; ++q)
        if (kinds[q] == kind)
            questions.push_back(Question(q));
    return questions;
}

namespace {

Function sliceFramed(const Plan &plan, Question question) {
    FramePlan frame = planFrame(plan);
    Function result;
    switch (question) {
    case Question::Surface: result = specializeSurface(plan, frame.all); break;
    case Question::View:
        result = specializePrepare(plan, plan.framed ? Stage::View : Stage::Surface, frame.all);
        break;
    case Question::Prepare: result = specializePrepare(plan, Stage::Surface, frame.scatter); break;
    default: result = specializeScatter(plan, frame.scatter); break;
    }
    result.frameSlots = int(frame.all.size());
    return result;
}

void removeAll(Op op, Region &region) {
    std::erase_if(region.body, [op](const Instruction &i) { return i.op == op; });
    for (Instruction &i : region.body)
        for (Region &inner : i.regions)
            removeAll(op, inner);
}

/// The planes that one emission's nine numbers go to, in the order of its operands.
std::vector<OutputSlot> emissionOutputs(int emission, int colorSamples) {
    std::vector<OutputSlot> slots;
    for (const OutputKind kind :
         {OutputKind::ConePosition, OutputKind::ConeAxis, OutputKind::ConeAngle,
          OutputKind::ConeExponent, OutputKind::ConeImportance})
        for (int c = 0; c < componentsOf(kind, colorSamples); ++c)
            slots.push_back({{kind, emission}, c});
    return slots;
}

std::vector<OutputSlot> emissionOutputs(const Function &whole) {
    std::vector<OutputSlot> slots;
    for (int n = 0; n < int(whole.emissions.size()); ++n)
        for (const OutputSlot &slot : emissionOutputs(n, whole.colors.samples))
            slots.push_back(slot);
    return slots;
}

/// Puts outputs where the region states emissions.
void writeEmissions(Region &region, const std::vector<OutputSlot> &slots) {
    std::vector<Instruction> body;
    for (Instruction &i : region.body) {
        for (Region &inner : i.regions)
            writeEmissions(inner, slots);
        if (i.op != Op::EmissionCone) {
            body.push_back(std::move(i));
            continue;
        }
        const int first = slotOf(slots, {OutputKind::ConePosition, i.immediate});
        for (int k = 0; k < int(i.operands.size()); ++k)
            body.push_back({.op = Op::Output,
                            .operands = {i.operands[size_t(k)]},
                            .results = {},
                            .regions = {},
                            .immediate = first + k,
                            .line = i.line});
    }
    region.body = std::move(body);
}

Function sliceEmission(const Function &whole) {
    Function result = whole;
    removeAll(Op::Print, result.body);
    removeAll(Op::Output, result.body);
    result.outputs = emissionOutputs(whole);
    writeEmissions(result.body, result.outputs);
    removeDeadCode(result);
    return result;
}

Function sliceQuestion(const Function &whole, Question question) {
    switch (question) {
    case Question::Shade:
    case Question::Light: {
        Function result = whole;
        if (question == Question::Shade)
            removeAll(Op::Print, result.body);
        removeAll(Op::EmissionCone, result.body);
        removeDeadCode(result);
        return result;
    }
    case Question::Emission: return sliceEmission(whole);
    case Question::Emit:
        return specializeUnder(*makePlan(whole), {}, OutputKind::Ci, OutputKind::Ce);
    case Question::Opacity:
        return specializeUnder(*makePlan(whole), {}, OutputKind::Oi, OutputKind::Oi);
    default: return sliceFramed(*makePlan(whole), question);
    }
}

std::vector<ConeSlot> coneSlots(const Plan &plan) {
    const std::vector<OutputSlot> outputs = prepareOutputs(plan);
    std::vector<ConeSlot> slots;
    for (int n = 0; n < int(plan.cones.size()); ++n) {
        const auto plane = [&](OutputKind kind) { return slotOf(outputs, {kind, n}); };
        slots.push_back({.request = plan.cones[n].request,
                         .axis = plane(OutputKind::ConeAxis),
                         .angle = plane(OutputKind::ConeAngle),
                         .exponent = plane(OutputKind::ConeExponent),
                         .importance = plane(OutputKind::ConeImportance),
                         .exact = plan.cones[n].exact});
    }
    return slots;
}

bool hasLoops(const Plan &plan) {
    for (const Instruction *i : plan.dependence.request)
        if (i && i->op == Op::LightLoop)
            return true;
    return false;
}

} // namespace

Function slice(const Function &whole, Question question) {
    Function result = sliceQuestion(whole, question);
    result.name = whole.name + "." + nameOf(question);
    return result;
}

SurfaceFacts surfaceFacts(const Function &whole) {
    auto plan = makePlan(whole);
    SurfaceFacts facts;
    facts.cones = coneSlots(*plan);
    facts.hasLoops = hasLoops(*plan);
    facts.readsAmbient = plan->readsAmbient;
    for (bool emits : plan->emits)
        facts.emits |= emits;
    facts.opaqueIfOsIs1 = opaqueIfOsIs1(slice(whole, Question::Opacity));
    AffineProof proof = proveAffine(whole);
    facts.affine = proof.affine;
    facts.notAffineLine = proof.line;
    facts.staticRequests = plan->dependence.staticRequests;
    facts.notStaticLine = plan->dependence.notStaticLine;
    return facts;
}

LightFacts lightFacts(const Function &whole) {
    LightFacts facts;
    const Function emission = slice(whole, Question::Emission);
    for (int n = 0; n < int(whole.emissions.size()); ++n) {
        const auto plane = [&](OutputKind kind) { return slotOf(emission.outputs, {kind, n}); };
        facts.cones.push_back({.request = n,
                               .axis = plane(OutputKind::ConeAxis),
                               .position = plane(OutputKind::ConePosition),
                               .angle = plane(OutputKind::ConeAngle),
                               .exponent = plane(OutputKind::ConeExponent),
                               .importance = plane(OutputKind::ConeImportance)});
    }
    for (int c = 0; c < 3; ++c)
        facts.conesAreTheLights &= !emission.inputsRead[size_t(ShaderInput::Ps) + size_t(c)];
    return facts;
}

} // namespace candela::ir
