// SPDX-License-Identifier: Apache-2.0
// The functions that share a frame: Surface, View, Prepare and Scatter.
#include "foundation/units/color.h"
#include "language/ir/builder_arithmetic.h"
#include "language/ir/builder_effects.h"
#include "language/ir/builder_sources.h"
#include "language/ir/dead_code.h"
#include "language/ir/plan.h"

#include <algorithm>
#include <set>

namespace candela::ir {

namespace {

/// Operations worth recomputing rather than loading. Between surface and view much is: a slot
/// there costs memory in every frame.
constexpr int scatterRecomputes = 1, viewRecomputes = 24;

void collectLoads(const Region &region, std::set<ValueId> &loads) {
    for (const Instruction &i : region.body) {
        if (i.op == Op::FrameLoad)
            loads.insert(ValueId(i.immediate));
        for (const Region &inner : i.regions)
            collectLoads(inner, loads);
    }
}

std::set<ValueId> loadsOf(const Function &function) {
    std::set<ValueId> loads;
    collectLoads(function.body, loads);
    return loads;
}

ValueId emissionKey(const Plan &plan, int channel) {
    return ValueId(plan.text.values.size()) + channel;
}

/// Ce of all channels under hypothesis 0; constant zero where that is proved.
std::vector<ValueId> emission(const Plan &plan, Specializer &teller, Builder &b) {
    std::vector<ValueId> Ce;
    for (int k = 0; k < colorSamples; ++k)
        Ce.push_back(plan.emits[k] ? teller.output(0, "Ci", k).value_or(number(b, 0))
                                   : number(b, 0));
    return Ce;
}

ValueId importanceOf(Specializer &teller, Builder &b, int hypothesis,
                     const std::vector<ValueId> &Ce) {
    ValueId sum = number(b, 0);
    for (int k = 0; k < colorSamples; ++k) {
        ValueId Ci = teller.output(hypothesis, "Ci", k).value_or(number(b, 0));
        sum = add(b, sum, mul(b, number(b, luminanceWeights[k]), sub(b, Ci, Ce[k])));
    }
    return max(b, sum, number(b, 0));
}

void finishFramed(const Plan &plan, Builder &b, Function &function,
                  const std::map<ValueId, int> &slots) {
    if (plan.framed) {
        function.frameSlots = 0;
        for (auto [value, slot] : slots)
            function.frameSlots = std::max(function.frameSlots, slot + 1);
    }
    b.finish();
    removeDeadCode(function);
}

} // namespace

std::vector<OutputSlot> prepareOutputs(const Plan &plan) {
    std::vector<OutputSlot> slots;
    for (std::size_t n = 0; n < plan.cones.size(); ++n) {
        std::string cone = "cone " + std::to_string(n);
        for (int k = 0; k < 3; ++k)
            slots.push_back({cone + " axis", k});
        slots.push_back({cone + " angle", 0});
        slots.push_back({cone + " exponent", 0});
        slots.push_back({cone + " importance", 0});
    }
    for (const char *name : {"Ce", "Ca", "Oi"})
        if (name != std::string("Ca") || plan.readsAmbient)
            for (int k = 0; k < colorSamples; ++k)
                slots.push_back({name, k});
    return slots;
}

Function tellPrepare(const Plan &plan, Stage first, const std::map<ValueId, int> &slots) {
    Function result = emptyLike(plan.text);
    result.outputs = prepareOutputs(plan);
    Builder b(result);
    Telling telling;
    telling.first = first;
    telling.framed = plan.framed;
    telling.fused = first == Stage::Surface;
    telling.recomputeCost = viewRecomputes;
    telling.prints = true;
    telling.slots = &slots;
    telling.cones = &plan.cones;
    telling.culls = &plan.culls;
    std::vector<Hypothesis> hypotheses{{}};
    if (plan.readsAmbient)
        hypotheses.push_back({Hypothesis::Light::None, true, nullptr});
    for (const Cone &cone : plan.cones)
        if (cone.kind != Cone::Kind::Stated)
            hypotheses.push_back({Hypothesis::Light::Probed, false, &cone});
    Specializer teller(plan.text, plan.dependence, b, hypotheses, telling);
    teller.run();
    std::vector<ValueId> Ce = emission(plan, teller, b);
    for (int k = 0; k < colorSamples; ++k) {
        output(b, "Ce", k, Ce[k]);
        if (plan.readsAmbient)
            output(b, "Ca", k, sub(b, teller.output(1, "Ci", k).value_or(number(b, 0)), Ce[k]));
        output(b, "Oi", k, teller.output(0, "Oi", k).value_or(number(b, 1)));
        if (auto slot = slots.find(emissionKey(plan, k)); slot != slots.end())
            b.emit(Op::FrameStore, {Ce[k]}, slot->second);
    }
    for (std::size_t h = 0; h < hypotheses.size(); ++h)
        if (const Cone *cone = hypotheses[h].probe)
            output(b, "cone " + std::to_string(cone - plan.cones.data()) + " importance", 0,
                   importanceOf(teller, b, int(h), Ce));
    finishFramed(plan, b, result, slots);
    return result;
}

Function tellSurface(const Plan &plan, const std::map<ValueId, int> &slots) {
    Function result = emptyLike(plan.text);
    Builder b(result);
    Telling telling;
    telling.last = Stage::Surface;
    telling.framed = true;
    telling.slots = &slots;
    telling.culls = &plan.culls;
    Specializer teller(plan.text, plan.dependence, b, {{}}, telling);
    if (plan.framed)
        teller.run();
    finishFramed(plan, b, result, slots);
    return result;
}

Function tellScatter(const Plan &plan, const std::map<ValueId, int> &slots) {
    Function result = emptyLike(plan.text);
    Builder b(result);
    Telling telling;
    telling.first = plan.framed ? Stage::Response : Stage::Surface;
    telling.framed = plan.framed;
    telling.recomputeCost = scatterRecomputes;
    telling.slots = &slots;
    telling.culls = &plan.culls;
    std::vector<Hypothesis> hypotheses{{Hypothesis::Light::Sampled, false, nullptr}};
    if (!plan.framed)
        hypotheses.push_back({});
    Specializer teller(plan.text, plan.dependence, b, hypotheses, telling);
    teller.run();
    for (int k = 0; k < colorSamples; ++k) {
        auto answered = teller.responseOutput("Ci", k);
        ValueId g = answered.value_or(number(b, 0));
        if (answered && plan.emits[k]) {
            ValueId key = emissionKey(plan, k);
            auto slot = slots.find(key);
            ValueId Ce = plan.framed ? b.emit(Op::FrameLoad, {},
                                              slot == slots.end() ? int(key) : slot->second)[0]
                                     : *teller.output(1, "Ci", k);
            g = sub(b, g, Ce);
        }
        output(b, "g", k, g);
    }
    finishFramed(plan, b, result, slots);
    return result;
}

FramePlan planFrame(const Plan &plan) {
    FramePlan frame;
    if (!plan.framed)
        return frame;
    std::set<ValueId> scatter = loadsOf(tellScatter(plan, {}));
    std::map<ValueId, int> byValue;
    for (ValueId v : scatter)
        byValue[v] = int(v);
    std::set<ValueId> view = loadsOf(tellPrepare(plan, Stage::View, byValue));
    int next = 0;
    for (ValueId v : scatter)
        frame.all[v] = frame.scatter[v] = next++;
    for (ValueId v : view)
        if (frame.all.try_emplace(v, next).second)
            ++next;
    return frame;
}

} // namespace candela::ir
