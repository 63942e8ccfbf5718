// SPDX-License-Identifier: Apache-2.0
#include "language/ir/questions/plan.h"

#include "foundation/units/color.h"
#include "language/ir/analyse/zero.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/regions.h"
#include "language/ir/transform/dead_code.h"

namespace candela::ir {

namespace {

/// Writes the text anew, so that equal values are one value and have one spill slot.
void eliminateCommonSubexpressions(Function &text, std::vector<ConeTest> &coneTests) {
    Dependence dependence = analyzeDependence(text);
    Function shared = emptyLike(text);
    Builder b(shared);
    SpecializationOptions options;
    options.prints = true;
    SpecializedText specialized =
        specialize(text, dependence, b, {{Assumption::Light::Given, true, nullptr}}, options);
    writeOutputs(specialized, text, b);
    for (ConeTest &test : coneTests)
        if (test.known) {
            test.axis = specialized.mapping.triple(0, test.axis);
            test.cosine = specialized.mapping.value(0, test.cosine);
        }
    b.finish();
    text = std::move(shared);
}

void readFacts(Plan &plan) {
    Function emission = specializeUnder(plan, {}, OutputKind::Ci, OutputKind::Ce);
    std::vector<bool> zero = provablyZero(emission);
    plan.emits.resize(size_t(plan.text.colors.samples));
    for (const Instruction &i : emission.body.body)
        if (i.op == Op::Output)
            plan.emits[emission.outputs[i.immediate].component] = !zero[i.operands[0]];
    Function ambient = specializeUnder(plan, {Assumption::Light::None, true, nullptr},
                                       OutputKind::Ci, OutputKind::Ca);
    const auto reads = [&](Op op) {
        return anyInstruction(ambient.body, [op](const Instruction &i) { return i.op == op; });
    };
    plan.readsIrradiance = reads(Op::Irradiance);
    plan.readsAmbient = plan.readsIrradiance || reads(Op::Ambient);
}

} // namespace

Function specializeUnder(const Plan &plan, const Assumption &assumption, OutputKind from,
                         OutputKind to) {
    Function result = emptyLike(plan.text);
    Builder b(result);
    SpecializationOptions options;
    options.coneTests = &plan.coneTests;
    SpecializedText specialized = specialize(plan.text, plan.dependence, b, {assumption}, options);
    for (int k = 0; k < plan.text.colors.samples; ++k)
        output(b, to, k, specialized.output(0, from, k).value_or(number(b, 0)));
    b.finish();
    removeDeadCode(result);
    return result;
}

std::shared_ptr<const Plan> makePlan(const Function &whole) {
    auto plan = std::make_shared<Plan>();
    plan->whole = withoutDisplacement(whole);
    plan->text = plan->whole;
    plan->coneTests = addConeTests(plan->text);
    eliminateCommonSubexpressions(plan->text, plan->coneTests);
    plan->dependence = analyzeDependence(plan->text);
    plan->framed = plan->dependence.staticRequests;
    plan->cones = conesOf(plan->text, plan->dependence, plan->framed);
    readFacts(*plan);
    plan->frame = planFrame(*plan);
    return plan;
}

} // namespace candela::ir
