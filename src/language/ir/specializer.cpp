// SPDX-License-Identifier: Apache-2.0
#include "language/ir/specializer.h"

#include "language/ir/builder_arithmetic.h"
#include "language/ir/builder_control.h"
#include "language/ir/builder_effects.h"
#include "language/ir/builder_sources.h"
#include "language/ir/op_info.h"

#include <algorithm>

namespace candela::ir {

namespace {
constexpr ValueId nothing = ValueId(-1);
constexpr int tooDear = 1 << 20;
} // namespace

Specializer::Specializer(const Function &text, const Dependence &dependence, Builder &b,
                         std::vector<Hypothesis> hypotheses, const Telling &telling)
    : text_(text), dependence_(dependence), b_(b), hypotheses_(std::move(hypotheses)),
      telling_(telling),
      maps_(hypotheses_.size(), std::vector<ValueId>(text.values.size(), nothing)) {
    for (int h = 0; h < int(hypotheses_.size()); ++h)
        active_.push_back(h);
}

std::optional<ValueId> Specializer::output(int hypothesis, const std::string &slot, int component) {
    auto it = outputs_.find({slot, component});
    return it == outputs_.end() ? std::nullopt : std::optional(value(hypothesis, it->second));
}

std::optional<ValueId> Specializer::responseOutput(const std::string &slot, int component) {
    auto it = outputs_.find({slot, component});
    bool lit = it != outputs_.end() && responds(it->second);
    return lit ? std::optional(value(0, it->second)) : std::nullopt;
}

Stage Specializer::stageOf(Stage stage) const {
    if (!telling_.framed)
        return Stage::Surface;
    return telling_.fused && stage == Stage::View ? Stage::Surface : stage;
}

ValueId Specializer::value(int hypothesis, ValueId old) {
    ValueId now = maps_[hypothesis][old];
    return now == nothing ? fetch(hypothesis, old) : now;
}

Values Specializer::valuesOf(int hypothesis, const Values &old) {
    Values now;
    for (ValueId v : old)
        now.push_back(value(hypothesis, v));
    return now;
}

Triple Specializer::triple(int hypothesis, const Triple &old) {
    return {value(hypothesis, old[0]), value(hypothesis, old[1]), value(hypothesis, old[2])};
}

/// A value of an earlier stage: recomputed where that is cheap, else from the frame. Slots hold
/// floats; integers and strings are always recomputed (see DependenceSweep::canBeSaved).
ValueId Specializer::fetch(int hypothesis, ValueId old) {
    auto definition = dependence_.definition[old];
    Type type = text_.values[old].type;
    bool slotless = type == Type::Integer || type == Type::String;
    if (slotless || cost(old) <= telling_.recomputeCost) {
        const Instruction &i = *definition.instruction;
        return b_.emit(i.op, valuesOf(hypothesis, i.operands), i.immediate,
                       i.number)[definition.result];
    }
    int slot = int(old);
    if (telling_.slots)
        if (auto it = telling_.slots->find(old); it != telling_.slots->end())
            slot = it->second;
    ValueId loaded = b_.emit(Op::FrameLoad, {}, slot)[0];
    return type == Type::Bool ? notEqual(b_, loaded, number(b_, 0)) : loaded;
}

/// Operations to compute the value from sources alone.
int Specializer::cost(ValueId v) const {
    const Instruction *i = dependence_.definition[v].instruction;
    if (!i || !isPure(i->op) || i->op == Op::Call || i->op >= Op::Random)
        return tooDear;
    if (i->operands.empty())
        return 0;
    if (i->op >= Op::Sin && i->op <= Op::Pow)
        return tooDear;
    int sum = 1;
    for (ValueId operand : i->operands) {
        sum += cost(operand);
        if (sum > telling_.recomputeCost)
            return tooDear;
    }
    return sum;
}

void Specializer::assignShared(ValueId old, ValueId now) {
    for (int h : active_)
        assign(h, old, now);
    save(old, now);
}

void Specializer::save(ValueId old, ValueId now) {
    if (!telling_.slots || loopDepth_ > 0 || retelling_ > 0 || responds(old))
        return;
    if (auto slot = telling_.slots->find(old); slot != telling_.slots->end())
        b_.emit(Op::FrameStore, {now}, slot->second);
}

/// The active hypotheses, those with the same condition together.
std::vector<std::vector<int>> Specializer::groupsBy(ValueId condition) {
    if (!responds(condition))
        return {active_};
    std::vector<std::vector<int>> groups;
    std::vector<ValueId> conditions;
    for (int h : active_) {
        ValueId now = value(h, condition);
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

/// Arrays that respond to light differ by hypothesis.
int Specializer::arrayFor(int hypothesis, int array) {
    bool shared = dependence_.arrayStage[array] < Stage::Response;
    auto [it, isNew] = arrays_.try_emplace({shared ? -1 : hypothesis, array});
    if (isNew)
        it->second = addArray(b_, text_.arrays[array].type, text_.arrays[array].size);
    return it->second;
}

void Specializer::walk(const Region &region, Range range) {
    for (const Instruction &i : region.body)
        walk(i, range);
}

void Specializer::walk(const Instruction &i, Range range) {
    b_.setLine(i.line);
    b_.setFile(i.file);
    switch (i.op) {
    case Op::Output: {
        const OutputSlot &slot = text_.outputs[i.immediate];
        outputs_[{slot.name, slot.component}] = i.operands[0];
        return;
    }
    case Op::Print: return walkPrint(i);
    case Op::If: return walkIf(i, range);
    case Op::Loop: return walkLoop(i, range);
    case Op::LightLoop: return walkLightLoop(i, range);
    case Op::Answer:
    case Op::Ambient:
    case Op::Irradiance: return walkAnswer(i, range);
    default: return walkPlain(i, range);
    }
}

void Specializer::walkPrint(const Instruction &i) {
    if (telling_.prints && active_[0] == 0)
        b_.emit(i.op, valuesOf(0, i.operands));
}

void Specializer::walkPlain(const Instruction &i, Range range) {
    bool memory = i.op == Op::ArrayLoad || i.op == Op::ArrayStore;
    Stage stage = memory ? dependence_.arrayStage[i.immediate] : dependence_.stage[i.results[0]];
    if (!range.has(stageOf(stage)))
        return;
    bool shared = stage < Stage::Response;
    for (int h : active_) {
        int immediate = memory ? arrayFor(h, i.immediate) : i.immediate;
        Values results = b_.emit(i.op, valuesOf(h, i.operands), immediate, i.number);
        for (std::size_t k = 0; k < i.results.size(); ++k)
            shared ? assignShared(i.results[k], results[k]) : assign(h, i.results[k], results[k]);
        if (shared)
            break;
    }
}

void Specializer::walkIf(const Instruction &i, Range range) {
    Stage condition = stageOf(i.operands[0]);
    auto hoist = [&](Stage last) {
        for (const Region &region : i.regions)
            walk(region, {range.first, last});
    };
    if (condition > range.last)
        return hoist(range.last);
    if (loopDepth_ == 0 && condition > range.first) {
        hoist(Stage(int(condition) - 1));
        range.first = condition;
    }
    // What a hoisted branch holds is not visible here: it is told again, but not saved again.
    // (No stores to memory are among it, since those stay behind all their conditions.)
    bool again = condition < range.first && range.first > telling_.first;
    Range content{again ? telling_.first : range.first, range.last};
    retelling_ += again;
    auto all = active_;
    for (auto &group : groupsBy(i.operands[0])) {
        active_ = group;
        emitIf(i, range, content);
    }
    active_ = all;
    retelling_ -= again;
}

void Specializer::emitIf(const Instruction &i, Range range, Range content) {
    auto group = active_;
    std::vector<std::pair<int, int>> kept; // Hypothesis, result.
    for (int k = 0; k < int(i.results.size()); ++k)
        if (range.has(stageOf(i.results[k])))
            for (int h : group) {
                kept.push_back({h, k});
                if (!responds(i.results[k]))
                    break;
            }
    auto branch = [&](const Region &region) {
        walk(region, content);
        Values yields;
        for (auto [h, k] : kept)
            yields.push_back(value(h, region.yields[k]));
        return yields;
    };
    ValueId condition = value(group[0], i.operands[0]);
    Values results = ifElse(
        b_, condition, [&] { return branch(i.regions[0]); }, [&] { return branch(i.regions[1]); });
    for (std::size_t n = 0; n < kept.size(); ++n) {
        auto [h, k] = kept[n];
        responds(i.results[k]) ? assign(h, i.results[k], results[n])
                               : assignShared(i.results[k], results[n]);
    }
}

bool Specializer::storesIn(const Region &region, Range range) const {
    for (const Instruction &i : region.body) {
        if (i.op == Op::ArrayStore && range.has(stageOf(dependence_.arrayStage[i.immediate])))
            return true;
        for (const Region &inner : i.regions)
            if (storesIn(inner, range))
                return true;
    }
    return false;
}

bool Specializer::wantsLoop(const Instruction &i, Range range) const {
    if (stageOf(i.regions[0].arguments[0]) > range.last)
        return false;
    if (loopDepth_ > 0 || !telling_.framed)
        return true;
    return storesIn(i.regions[0], range) ||
           std::any_of(i.results.begin(), i.results.end(),
                       [&](ValueId v) { return range.has(stageOf(v)); });
}

void Specializer::walkLoop(const Instruction &i, Range range) {
    if (!wantsLoop(i, range) || (telling_.unrolls && unrollLoop(i, range)))
        return;
    ValueId condition = i.regions[0].arguments[0];
    auto all = active_;
    if (!responds(condition)) {
        emitLoop(i, range);
    } else {
        for (int h : all) {
            active_ = {h};
            emitLoop(i, range);
        }
    }
    active_ = all;
}

/// Tells the whole loop, also what belongs to earlier stages: it differs from turn to turn and so
/// cannot come from the frame.
void Specializer::emitLoop(const Instruction &i, Range range) {
    auto group = active_;
    const Region &region = i.regions[0];
    std::vector<std::pair<int, int>> carried; // Hypothesis, which.
    Values initial;
    for (int k = 0; k < int(i.results.size()); ++k) {
        if (stageOf(i.results[k]) > range.last)
            continue;
        for (int h : group) {
            carried.push_back({h, k});
            initial.push_back(value(h, i.operands[k]));
            if (!responds(i.results[k]))
                break;
        }
    }
    auto spread = [&](const Values &old, const Values &now, bool onlyInRange) {
        for (std::size_t n = 0; n < carried.size(); ++n) {
            auto [h, k] = carried[n];
            if (onlyInRange && !range.has(stageOf(old[k])))
                continue;
            responds(old[k]) ? assign(h, old[k], now[n]) : assignShared(old[k], now[n]);
        }
    };
    Values results = loop(b_, initial, [&](const Values &arguments) {
        ++loopDepth_;
        spread(region.arguments, arguments, false);
        walk(region, {Stage::Surface, range.last});
        Values yields;
        for (auto [h, k] : carried)
            yields.push_back(value(h, region.yields[k]));
        --loopDepth_;
        return yields;
    });
    spread(i.results, results, loopDepth_ == 0);
}

} // namespace candela::ir
