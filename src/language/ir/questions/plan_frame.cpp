// SPDX-License-Identifier: Apache-2.0
// The functions that share frames: Surface, View, Prepare and Scatter.
#include "foundation/units/color.h"
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/regions.h"
#include "language/ir/questions/answers.h"
#include "language/ir/transform/dead_code.h"

#include <algorithm>
#include <optional>
#include <set>

namespace candela::ir {

namespace {

using Slots = std::map<ValueId, int>;

/// Operations worth recomputing rather than loading. Between surface and view much is: a slot
/// there costs memory at every point.
constexpr int scatterRecomputes = 1, viewRecomputes = 24;
/// Instructions of Prepare: each cone is probed in a walk through all that responds to light; and
/// what values become there, for all cones.
constexpr std::size_t mostPrepared = mostInstructions / 2, mostMapped = 1 << 24;

std::set<ValueId> loadsOf(const Function &function) {
    std::set<ValueId> loads;
    forEachInstruction(function.body, [&](const Instruction &i) {
        if (i.op == Op::FrameLoad)
            loads.insert(ValueId(i.immediate));
    });
    return loads;
}

/// There are loops whose turns are counted.
bool mayEndLoops(const Plan &plan) {
    return anyInstruction(
        plan.text.body, [](const Instruction &i) { return i.op == Op::Loop && i.immediate == 0; });
}

ValueId emissionKey(const Plan &plan, int channel) {
    return ValueId(plan.text.values.size()) + channel;
}

/// Ce of all channels under assumption 0; constant zero where that is proved.
std::vector<ValueId> emission(const Plan &plan, SpecializedText &specialized, Builder &b) {
    std::vector<ValueId> Ce;
    for (int k = 0; k < plan.text.colors.samples; ++k)
        Ce.push_back(plan.emits[k] ? specialized.output(0, OutputKind::Ci, k).value_or(number(b, 0))
                                   : number(b, 0));
    return Ce;
}

ValueId importanceOf(SpecializedText &specialized, Builder &b, int assumption,
                     const std::vector<ValueId> &Ce) {
    const std::vector<float> weights = b.colors().luminance();
    ValueId sum = number(b, 0);
    for (int k = 0; k < b.colors().samples; ++k) {
        ValueId Ci = specialized.output(assumption, OutputKind::Ci, k).value_or(number(b, 0));
        sum = add(b, sum, mul(b, number(b, weights[k]), sub(b, Ci, Ce[k])));
    }
    return max(b, sum, number(b, 0));
}

/// Of the value with the key.
BindingTime frameOf(const Plan &plan, ValueId key) {
    const auto &times = plan.dependence.bindingTime;
    return key < times.size() ? times[key] : BindingTime::View;
}

void finishFramed(const Plan &plan, Builder &b, Function &function) {
    function.surfaceSlots = plan.frame.surfaceSlots;
    function.viewSlots = plan.frame.viewSlots;
    b.finish();
    removeDeadCode(function);
}

} // namespace

std::vector<OutputSlot> prepareOutputs(const Plan &plan) {
    std::vector<OutputSlot> slots;
    const auto add = [&](const OutputName &name) {
        addOutputSlots(slots, name, plan.text.colors.samples);
    };
    for (int n = 0; n < int(plan.cones.size()); ++n)
        for (OutputKind kind : {OutputKind::ConeAxis, OutputKind::ConeAngle,
                                OutputKind::ConeExponent, OutputKind::ConeImportance})
            add({kind, n});
    add(OutputKind::Ce);
    if (plan.readsAmbient)
        add(OutputKind::Ca);
    add(OutputKind::Oi);
    if (mayEndLoops(plan))
        add(OutputKind::Completed);
    return slots;
}

/// With the importance of the first `probes` cones that are not stated; of the others it is said to
/// be 1. Nothing if it becomes too large, which it does not without probes.
static std::optional<Function> prepareWith(const Plan &plan, BindingTime first, const Slots &slots,
                                           std::size_t probes) {
    Function result = emptyLike(plan.text);
    result.outputs = prepareOutputs(plan);
    Builder b(result, probes > 0 ? Budget(mostPrepared) : Budget());
    SpecializationOptions options;
    options.first = first;
    options.framed = plan.framed;
    options.fused = first == BindingTime::Surface;
    options.recomputeCost = viewRecomputes;
    options.prints = true;
    options.slots = &slots;
    options.cones = &plan.cones;
    options.coneTests = &plan.coneTests;
    std::vector<Assumption> assumptions{{}};
    if (plan.readsAmbient)
        assumptions.push_back({Assumption::Light::None, true, nullptr});
    const auto isProbed = [&](const Cone &cone) {
        return cone.kind != Cone::Kind::Stated && std::size_t(&cone - plan.cones.data()) < probes;
    };
    for (const Cone &cone : plan.cones)
        if (isProbed(cone))
            assumptions.push_back({Assumption::Light::Probed, false, &cone});
    SpecializedText specialized = specialize(plan.text, plan.dependence, b, assumptions, options);
    std::vector<ValueId> Ce = emission(plan, specialized, b);
    for (int k = 0; k < plan.text.colors.samples; ++k) {
        output(b, OutputKind::Ce, k, Ce[k]);
        if (plan.readsAmbient)
            output(b, OutputKind::Ca, k,
                   sub(b, specialized.output(1, OutputKind::Ci, k).value_or(number(b, 0)), Ce[k]));
        output(b, OutputKind::Oi, k,
               specialized.output(0, OutputKind::Oi, k).value_or(number(b, 1)));
        if (auto slot = slots.find(emissionKey(plan, k)); slot != slots.end())
            b.emit(Op::FrameStore, {Ce[k]}, slot->second);
    }
    for (std::size_t h = 0; h < assumptions.size(); ++h)
        if (const Cone *cone = assumptions[h].probe)
            output(b, {OutputKind::ConeImportance, int(cone - plan.cones.data())}, 0,
                   importanceOf(specialized, b, int(h), Ce));
    for (std::size_t n = probes; n < plan.cones.size(); ++n)
        if (plan.cones[n].kind != Cone::Kind::Stated)
            output(b, {OutputKind::ConeImportance, int(n)}, 0, number(b, 1));
    if (mayEndLoops(plan))
        output(b, OutputKind::Completed, 0, number(b, 1));
    if (b.budget().exceeded() || (probes > 0 && arrayNumbers(result) > mostArrayNumbers))
        return {};
    finishFramed(plan, b, result);
    return result;
}

/// Loads and stores that `slots` does not name are numbered by their keys; here and below.
static Function specializePrepare(const Plan &plan, BindingTime first, const Slots &slots) {
    const std::size_t most = mostMapped / (plan.text.values.size() + 1);
    for (std::size_t probes = std::min(plan.cones.size(), most);; probes /= 4)
        if (auto prepared = prepareWith(plan, first, slots, probes))
            return std::move(*prepared);
}

static Function specializeSurface(const Plan &plan, const Slots &slots) {
    Function result = emptyLike(plan.text);
    Builder b(result);
    SpecializationOptions options;
    options.last = BindingTime::Surface;
    options.framed = true;
    options.slots = &slots;
    options.coneTests = &plan.coneTests;
    if (plan.framed)
        specialize(plan.text, plan.dependence, b, {{}}, options);
    finishFramed(plan, b, result);
    return result;
}

static Function specializeScatter(const Plan &plan, const Slots &slots) {
    Function result = emptyLike(plan.text);
    Builder b(result);
    SpecializationOptions options;
    options.first = plan.framed ? BindingTime::Response : BindingTime::Surface;
    options.framed = plan.framed;
    options.recomputeCost = scatterRecomputes;
    options.slots = &slots;
    options.coneTests = &plan.coneTests;
    std::vector<Assumption> assumptions{{Assumption::Light::Sampled, false, nullptr}};
    if (!plan.framed)
        assumptions.push_back({});
    SpecializedText specialized = specialize(plan.text, plan.dependence, b, assumptions, options);
    for (int k = 0; k < plan.text.colors.samples; ++k) {
        auto answered = specialized.responseOutput(OutputKind::Ci, k);
        ValueId g = answered.value_or(number(b, 0));
        if (answered && plan.emits[k]) {
            ValueId key = emissionKey(plan, k);
            auto slot = slots.find(key);
            ValueId Ce = plan.framed ? b.emit(Op::FrameLoad, {},
                                              slot == slots.end() ? int(key) : slot->second)[0]
                                     : *specialized.output(1, OutputKind::Ci, k);
            g = sub(b, g, Ce);
        }
        output(b, OutputKind::G, k, g);
    }
    finishFramed(plan, b, result);
    return result;
}

FramePlan planFrame(const Plan &plan) {
    FramePlan frame;
    if (!plan.framed)
        return frame;
    const std::set<ValueId> scatter = loadsOf(specializeScatter(plan, {}));
    Slots byValue;
    for (ValueId v : scatter)
        byValue[v] = int(v);
    const std::set<ValueId> view = loadsOf(specializePrepare(plan, BindingTime::View, byValue));
    const auto number = [&](const std::set<ValueId> &values, BindingTime of, int first,
                            int &slots) {
        for (ValueId v : values)
            if (frameOf(plan, v) == of && frame.all.try_emplace(v, first + slots).second)
                ++slots;
    };
    for (const std::set<ValueId> *values : {&scatter, &view})
        number(*values, BindingTime::Surface, 0, frame.surfaceSlots);
    number(scatter, BindingTime::View, frame.surfaceSlots, frame.viewSlots);
    for (ValueId v : scatter)
        frame.scatter[v] = frame.all.at(v);
    return frame;
}

Function answerSurface(const Plan &plan) { return specializeSurface(plan, plan.frame.all); }

Function answerView(const Plan &plan) {
    return specializePrepare(plan, plan.framed ? BindingTime::View : BindingTime::Surface,
                             plan.frame.all);
}

Function answerPrepare(const Plan &plan) {
    return specializePrepare(plan, BindingTime::Surface, plan.frame.scatter);
}

Function answerScatter(const Plan &plan) { return specializeScatter(plan, plan.frame.scatter); }

} // namespace candela::ir
