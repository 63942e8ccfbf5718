// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/specialize.h"

#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/transform/specialization.h"

#include <algorithm>

namespace candela::ir {

Function emptyLike(const Function &whole) {
    Function result;
    result.name = whole.name;
    result.colors = whole.colors;
    result.requests = whole.requests;
    result.emissions = whole.emissions;
    result.services = whole.services;
    result.maps = whole.maps;
    result.images = whole.images;
    result.strings = whole.strings;
    result.files = whole.files;
    result.spaces = whole.spaces;
    result.categories = whole.categories;
    result.parameters = whole.parameters;
    result.variables = whole.variables;
    result.mostTurns = whole.mostTurns;
    result.isEndless = whole.isEndless;
    return result;
}

std::optional<ValueId> SpecializedText::output(int assumption, const OutputName &name,
                                               int component) {
    auto it = outputs.find({name, component});
    return it == outputs.end() ? std::nullopt
                               : std::optional(mapping.value(assumption, it->second));
}

std::optional<ValueId> SpecializedText::responseOutput(const OutputName &name, int component) {
    auto it = outputs.find({name, component});
    bool lit = it != outputs.end() && dependence.responds(it->second);
    return lit ? std::optional(mapping.value(0, it->second)) : std::nullopt;
}

void writeOutputs(SpecializedText &specialized, const Function &text, Builder &b) {
    for (const OutputSlot &slot : text.outputs)
        if (const auto v = specialized.output(0, slot.name, slot.component))
            output(b, slot.name, slot.component, *v);
}

SpecializedText specialize(const Function &text, const Dependence &dependence, Builder &b,
                           const std::vector<Assumption> &assumptions,
                           const SpecializationOptions &options) {
    Specialization s(text, dependence, b, assumptions, options);
    walk(s, text.body, {options.first, options.last});
    return {dependence, std::move(s.mapping), std::move(s.outputs)};
}

Specialization::Specialization(const Function &text, const Dependence &dependence, Builder &b,
                               const std::vector<Assumption> &assumptions,
                               const SpecializationOptions &options)
    : text(text), dependence(dependence), b(b), assumptions(assumptions), options(options),
      mapping(text, dependence, b, int(assumptions.size()), options.recomputeCost, options.slots) {
    for (int h = 0; h < int(assumptions.size()); ++h)
        active.push_back(h);
}

BindingTime Specialization::counted(BindingTime time) const {
    if (!options.framed)
        return BindingTime::Surface;
    return options.fused && time == BindingTime::View ? BindingTime::Surface : time;
}

void Specialization::assignShared(ValueId old, ValueId now) {
    for (int h : active)
        mapping.assign(h, old, now);
    if (loopDepth == 0 && repeating == 0)
        mapping.save(old, now);
}

namespace {

/// The active assumptions, those with the same condition together.
std::vector<std::vector<int>> groupsBy(Specialization &s, ValueId condition) {
    if (!s.dependence.responds(condition))
        return {s.active};
    std::vector<std::vector<int>> groups;
    std::vector<ValueId> conditions;
    for (int h : s.active) {
        ValueId now = s.mapping.value(h, condition);
        auto known = std::find(conditions.begin(), conditions.end(), now);
        if (known == conditions.end()) {
            conditions.push_back(now);
            groups.push_back({h});
        } else {
            groups[known - conditions.begin()].push_back(h);
        }
    }
    return groups;
}

/// What is said once, whatever the assumptions, and only where it stands.
void walkStatement(Specialization &s, const Instruction &i) {
    if (s.options.prints && s.active[0] == 0 && s.ahead == 0)
        s.b.emit(i.op, s.mapping.values(0, i.operands), i.immediate);
}

void walkPlain(Specialization &s, const Instruction &i, BindingTimes range) {
    bool memory = i.op == Op::ArrayLoad || i.op == Op::ArrayStore;
    BindingTime time = memory ? s.dependence.arrayBindingTime[i.immediate]
                              : s.dependence.bindingTime[i.results[0]];
    if (!range.has(s.counted(time)))
        return;
    bool shared = time < BindingTime::Response;
    for (int h : s.active) {
        int immediate = memory ? s.mapping.array(h, i.immediate, s.loopDepth) : i.immediate;
        Values results = s.b.emit(i.op, s.mapping.values(h, i.operands), immediate, i.number);
        for (std::size_t k = 0; k < i.results.size(); ++k)
            shared ? s.assignShared(i.results[k], results[k])
                   : s.mapping.assign(h, i.results[k], results[k]);
        if (shared)
            break;
    }
}

/// `content` is the range of binding times that the branches hold.
void emitIf(Specialization &s, const Instruction &i, BindingTimes range, BindingTimes content) {
    std::vector<std::pair<int, int>> kept; // Assumption, result.
    for (int k = 0; k < int(i.results.size()); ++k)
        if (range.has(s.bindingTimeOf(i.results[k])))
            for (int h : s.active) {
                kept.push_back({h, k});
                if (!s.dependence.responds(i.results[k]))
                    break;
            }
    auto branch = [&](const Region &region) {
        walk(s, region, content);
        Values yields;
        for (auto [h, k] : kept)
            yields.push_back(s.mapping.value(h, region.yields[k]));
        return yields;
    };
    ValueId condition = s.mapping.value(s.active[0], i.operands[0]);
    Values results = ifElse(
        s.b, condition, [&] { return branch(i.regions[0]); }, [&] { return branch(i.regions[1]); });
    for (std::size_t n = 0; n < kept.size(); ++n) {
        auto [h, k] = kept[n];
        s.dependence.responds(i.results[k]) ? s.mapping.assign(h, i.results[k], results[n])
                                            : s.assignShared(i.results[k], results[n]);
    }
}

void walkIf(Specialization &s, const Instruction &i, BindingTimes range) {
    BindingTime condition = s.bindingTimeOf(i.operands[0]);
    auto hoist = [&](BindingTime last) {
        for (const Region &region : i.regions)
            walkAhead(s, region, {range.first, last});
    };
    if (condition > range.last)
        return hoist(range.last);
    if (s.loopDepth == 0 && condition > range.first) {
        hoist(BindingTime(int(condition) - 1));
        range.first = condition;
    }
    // What a hoisted branch holds is not visible here: it is written again, but not saved again.
    // (No stores to memory are among it, since those stay behind all their conditions.)
    bool again = condition < range.first && range.first > s.options.first;
    BindingTimes content{again ? s.options.first : range.first, range.last};
    s.repeating += again;
    for (auto &group : groupsBy(s, i.operands[0]))
        s.under(group, [&] { emitIf(s, i, range, content); });
    s.repeating -= again;
}

/// What was too large is thrown away: the rest is not written any more, for every assumption, only
/// to be dropped. Whoever is above still finds values of the right types.
void passOver(Specialization &s, const Instruction &i) {
    for (ValueId old : i.results) {
        const ValueId stand = s.b.newValue(s.text.values[old].type, Uniformity::Varying);
        for (int h : s.active)
            s.mapping.assign(h, old, stand);
    }
}

} // namespace

static void walk(Specialization &s, const Instruction &i, BindingTimes range) {
    if (s.b.budget().exceeded())
        return passOver(s, i);
    s.b.setLine(i.line);
    s.b.setFile(i.file);
    switch (i.op) {
    case Op::Output: {
        const OutputSlot &slot = s.text.outputs[i.immediate];
        s.outputs[{slot.name, slot.component}] = i.operands[0];
        return;
    }
    case Op::Command:
    case Op::ImageStore:
    case Op::EmissionCone: return walkStatement(s, i);
    case Op::If: return walkIf(s, i, range);
    case Op::Loop: return walkLoop(s, i, range);
    case Op::LightLoop: return walkLightLoop(s, i, range);
    case Op::Answer:
    case Op::Ambient:
    case Op::Irradiance: return walkAnswer(s, i, range);
    default: return walkPlain(s, i, range);
    }
}

void walk(Specialization &s, const Region &region, BindingTimes range) {
    for (const Instruction &i : region.body)
        walk(s, i, range);
}

void walkAhead(Specialization &s, const Region &region, BindingTimes range) {
    ++s.ahead;
    walk(s, region, range);
    --s.ahead;
}

} // namespace candela::ir
