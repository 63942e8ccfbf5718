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

void removePrints(Region &region) {
    std::erase_if(region.body, [](const Instruction &i) { return i.op == Op::Print; });
    for (Instruction &i : region.body)
        for (Region &inner : i.regions)
            removePrints(inner);
}

Function sliceQuestion(const Function &whole, Question question) {
    switch (question) {
    case Question::Shade:
    case Question::Light: {
        Function result = whole;
        if (question == Question::Shade)
            removePrints(result.body);
        removeDeadCode(result);
        return result;
    }
    case Question::Emit: return specializeUnder(*makePlan(whole), {}, "Ci", "Ce");
    case Question::Opacity: return specializeUnder(*makePlan(whole), {}, "Oi", "Oi");
    default: return sliceFramed(*makePlan(whole), question);
    }
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
    for (std::size_t n = 0; n < plan->cones.size(); ++n)
        facts.cones.push_back({plan->cones[n].request, int(6 * n), plan->cones[n].exact});
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

} // namespace candela::ir
