// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/affine.h"
#include "language/ir/analyse/opacity.h"
#include "language/ir/questions/emission.h"
#include "language/ir/questions/plan.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/dead_code.h"
#include "language/ir/transform/short_loops.h"

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
    const FramePlan &frame = plan.frame;
    Function result;
    switch (question) {
    case Question::Surface: result = specializeSurface(plan, frame.all); break;
    case Question::View:
        result = specializePrepare(plan, plan.framed ? BindingTime::View : BindingTime::Surface,
                                   frame.all);
        break;
    case Question::Prepare:
        result = specializePrepare(plan, BindingTime::Surface, frame.scatter);
        break;
    default: result = specializeScatter(plan, frame.scatter); break;
    }
    result.spillSlots = int(frame.all.size());
    return result;
}

/// Shade and the questions to lights, which take the text as it is.
Function sliceWhole(const Function &whole, Question question) {
    if (question == Question::Emission)
        return sliceEmission(whole);
    Function result = whole;
    if (question == Question::Shade)
        removeAll(Op::Command, result.body);
    removeAll(Op::EmissionCone, result.body);
    removeDeadCode(result);
    return result;
}

bool takesWhole(Question question) {
    return question == Question::Shade || question == Question::Light ||
           question == Question::Emission;
}

Function sliceQuestion(const Plan &plan, Question question) {
    if (takesWhole(question))
        return sliceWhole(plan.whole, question);
    switch (question) {
    case Question::Emit: return specializeUnder(plan, {}, OutputKind::Ci, OutputKind::Ce);
    case Question::Opacity: return specializeUnder(plan, {}, OutputKind::Oi, OutputKind::Oi);
    default: return sliceFramed(plan, question);
    }
}

std::vector<ConeSlot> coneSlots(const Plan &plan) {
    const std::vector<OutputSlot> outputs = prepareOutputs(plan);
    std::vector<ConeSlot> slots;
    for (int n = 0; n < int(plan.cones.size()); ++n) {
        slots.push_back(coneSlot(outputs, n, plan.cones[n].request));
        slots.back().exact = plan.cones[n].exact;
    }
    return slots;
}

Function named(Function function, const Function &whole, Question question) {
    function.name = whole.name + "." + nameOf(question);
    markShortLoops(function);
    return function;
}

bool hasLoops(const Plan &plan) {
    for (const Instruction *i : plan.dependence.request)
        if (i && i->op == Op::LightLoop)
            return true;
    return false;
}

} // namespace

Function slice(const Plan &plan, Question question) {
    return named(sliceQuestion(plan, question), plan.whole, question);
}

Function slice(const Function &whole, Question question) {
    return takesWhole(question) ? named(sliceWhole(whole, question), whole, question)
                                : slice(*makePlan(whole), question);
}

SurfaceFacts surfaceFacts(const Plan &plan) {
    SurfaceFacts facts;
    facts.cones = coneSlots(plan);
    facts.hasLoops = hasLoops(plan);
    facts.readsAmbient = plan.readsAmbient;
    for (bool emits : plan.emits)
        facts.emits |= emits;
    facts.opaqueIfOsIs1 = opaqueIfOsIs1(slice(plan, Question::Opacity));
    AffineProof proof = proveAffine(plan.whole);
    facts.affine = proof.affine;
    facts.notAffineLine = proof.line;
    facts.staticRequests = plan.dependence.staticRequests;
    facts.notStaticLine = plan.dependence.notStaticLine;
    return facts;
}

SurfaceFacts surfaceFacts(const Function &whole) { return surfaceFacts(*makePlan(whole)); }

} // namespace candela::ir
