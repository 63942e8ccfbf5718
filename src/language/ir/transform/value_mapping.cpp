// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/value_mapping.h"
#include "language/ir/analyse/dependence.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/op_info.h"

#include <algorithm>

namespace candela::ir {

namespace {
constexpr ValueId nothing = ValueId(-1);
constexpr int tooDear = 1 << 20;
} // namespace

ValueMapping::ValueMapping(const Function &text, const Dependence &dependence, Builder &b,
                           int assumptions, int recomputeCost, const std::map<ValueId, int> *slots)
    : text_(text), dependence_(dependence), b_(b), recomputeCost_(recomputeCost), slots_(slots),
      maps_(assumptions, std::vector<ValueId>(text.values.size(), nothing)) {}

std::optional<ValueId> ValueMapping::known(int assumption, ValueId old) const {
    ValueId now = maps_[assumption][old];
    return now == nothing ? std::nullopt : std::optional(now);
}

ValueId ValueMapping::value(int assumption, ValueId old) {
    ValueId now = maps_[assumption][old];
    return now == nothing ? rematerialise(assumption, old) : now;
}

Values ValueMapping::values(int assumption, const Values &old) {
    Values now;
    for (ValueId v : old)
        now.push_back(value(assumption, v));
    return now;
}

Triple ValueMapping::triple(int assumption, const Triple &old) {
    return {value(assumption, old[0]), value(assumption, old[1]), value(assumption, old[2])};
}

/// Slots hold floats; integers and strings are always recomputed (see
/// DependenceSweep::canBeSaved).
ValueId ValueMapping::rematerialise(int assumption, ValueId old) {
    auto definition = dependence_.definition[old];
    Type type = text_.values[old].type;
    bool slotless = type == Type::Integer || type == Type::String;
    if (slotless || cost(old) <= recomputeCost_) {
        const Instruction &i = *definition.instruction;
        return b_.emit(i.op, values(assumption, i.operands), i.immediate,
                       i.number)[definition.result];
    }
    int slot = int(old);
    if (slots_)
        if (auto it = slots_->find(old); it != slots_->end())
            slot = it->second;
    ValueId loaded = b_.emit(Op::FrameLoad, {}, slot)[0];
    return type == Type::Bool ? notEqual(b_, loaded, number(b_, 0)) : loaded;
}

/// To compute the value from sources alone, in units of an addition.
int ValueMapping::cost(ValueId v) const {
    const Instruction *i = dependence_.definition[v].instruction;
    if (!i || !isPure(i->op) || isService(i->op))
        return tooDear;
    int sum = costOf(text_, *i);
    for (ValueId operand : i->operands) {
        if (sum > recomputeCost_)
            return tooDear;
        sum += cost(operand);
    }
    return sum > recomputeCost_ ? tooDear : sum;
}

void ValueMapping::save(ValueId old, ValueId now) {
    if (!slots_ || dependence_.responds(old))
        return;
    if (auto slot = slots_->find(old); slot != slots_->end())
        b_.emit(Op::FrameStore, {now}, slot->second);
}

int ValueMapping::array(int assumption, int old, int loopDepth) {
    bool shared = dependence_.arrayBindingTime[old] < BindingTime::Response;
    auto [it, isNew] = arrays_.try_emplace({shared ? -1 : assumption, old});
    if (isNew) {
        const Array &known = text_.arrays[old];
        it->second = addArray(b_, known.type, known.size);
        // What is declared in a loop is first set there.
        b_.function().arrays[it->second].loopDepth = std::min(known.loopDepth, loopDepth);
    }
    return it->second;
}

} // namespace candela::ir
