// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/affine.h"
#include "language/ir/analyse/opacity.h"
#include "language/ir/questions/plan.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/dead_code.h"

namespace candela::ir {

const char *nameOf(Question question) {
    constexpr const char *names[] = {"shade",   "surface", "view",    "prepare",
                                     "scatter", "emit",    "opacity", "light"};
    return names[int(question)];
}

namespace {

Function sliceFramed(const Plan &plan, Question question) {
    const FramePlan &frame = plan.frame;
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

void removePrints(Region &region) {
    std::erase_if(region.body, [](const Instruction &i) { return i.op == Op::Print; });
    for (Instruction &i : region.body)
        for (Region &inner : i.regions)
            removePrints(inner);
}

/// Shade and Light, which take the text as it is.
Function sliceWhole(const Function &whole, Question question) {
    Function result = whole;
    if (question == Question::Shade)
        removePrints(result.body);
    removeDeadCode(result);
    return result;
}

bool takesWhole(Question question) {
    return question == Question::Shade || question == Question::Light;
}

Function sliceQuestion(const Plan &plan, Question question) {
    if (takesWhole(question))
        return sliceWhole(plan.whole, question);
    switch (question) {
    case Question::Emit: return specializeUnder(plan, {}, "Ci", "Ce");
    case Question::Opacity: return specializeUnder(plan, {}, "Oi", "Oi");
    default: return sliceFramed(plan, question);
    }
}

Function named(Function function, const Function &whole, Question question) {
    function.name = whole.name + "." + nameOf(question);
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
    for (std::size_t n = 0; n < plan.cones.size(); ++n)
        facts.cones.push_back({plan.cones[n].request, int(6 * n), plan.cones[n].exact});
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
