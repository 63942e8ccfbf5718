// SPDX-License-Identifier: Apache-2.0
#include "language/ir/questions/plan.h"

#include "foundation/units/color.h"
#include "language/ir/analyse/zero.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/transform/dead_code.h"

#include <functional>

namespace candela::ir {

namespace {

/// Writes the text anew, so that equal values are one value and have one frame slot.
void eliminateCommonSubexpressions(Function &text, std::vector<ConeTest> &coneTests) {
    Dependence dependence = analyzeDependence(text);
    Function shared = emptyLike(text);
    Builder b(shared);
    SpecializationOptions options;
    options.prints = true;
    SpecializedText specialized =
        specialize(text, dependence, b, {{Assumption::Light::Given, true, nullptr}}, options);
    for (const OutputSlot &slot : text.outputs)
        if (auto v = specialized.output(0, slot.name, slot.component))
            output(b, slot.name, slot.component, *v);
    for (ConeTest &test : coneTests)
        if (test.known) {
            test.axis = specialized.mapping.triple(0, test.axis);
            test.cosine = specialized.mapping.value(0, test.cosine);
        }
    b.finish();
    text = std::move(shared);
}

bool holds(const Region &region, const std::function<bool(const Instruction &)> &test) {
    for (const Instruction &i : region.body) {
        if (test(i))
            return true;
        for (const Region &inner : i.regions)
            if (holds(inner, test))
                return true;
    }
    return false;
}

void readFacts(Plan &plan) {
    Function emission = specializeUnder(plan, {}, "Ci", "Ce");
    std::vector<bool> zero = provablyZero(emission);
    for (const Instruction &i : emission.body.body)
        if (i.op == Op::Output)
            plan.emits[emission.outputs[i.immediate].component] = !zero[i.operands[0]];
    Function ambient = specializeUnder(plan, {Assumption::Light::None, true, nullptr}, "Ci", "Ca");
    plan.readsAmbient = holds(ambient.body, [](const Instruction &i) {
        return i.op == Op::Ambient || i.op == Op::Irradiance;
    });
}

} // namespace

Function specializeUnder(const Plan &plan, const Assumption &assumption, const std::string &from,
                         const std::string &slot) {
    Function result = emptyLike(plan.text);
    Builder b(result);
    SpecializationOptions options;
    options.coneTests = &plan.coneTests;
    SpecializedText specialized = specialize(plan.text, plan.dependence, b, {assumption}, options);
    for (int k = 0; k < colorSamples; ++k)
        output(b, slot, k, specialized.output(0, from, k).value_or(number(b, 0)));
    b.finish();
    removeDeadCode(result);
    return result;
}

std::unique_ptr<Plan> makePlan(const Function &whole) {
    auto plan = std::make_unique<Plan>();
    plan->text = whole;
    removeDeadCode(plan->text);
    plan->coneTests = addConeTests(plan->text);
    eliminateCommonSubexpressions(plan->text, plan->coneTests);
    plan->dependence = analyzeDependence(plan->text);
    plan->framed = plan->dependence.staticRequests;
    plan->cones = conesOf(plan->text, plan->dependence, plan->framed);
    readFacts(*plan);
    return plan;
}

} // namespace candela::ir
