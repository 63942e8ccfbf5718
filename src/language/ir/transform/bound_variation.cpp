// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/bound_variation.h"

#include "language/ir/core/dataflow.h"
#include "language/ir/transform/bound_sources.h"

#include <algorithm>

namespace candela::ir {

bool variesByItself(const Function &function, const Instruction &i) {
    switch (info(i.op).bound) {
    case BoundRule::Unknown:
    case BoundRule::Fraction: return true;
    case BoundRule::Service: return serviceOf(function, i).info->bound != ServiceBound::Constant;
    case BoundRule::Source:
        return i.op == Op::Variable || (i.op == Op::Input && inputVaries(i.immediate));
    default: return false;
    }
}

namespace {

struct Variation : ForwardAnalysis<bool> {
    using ForwardAnalysis::ForwardAnalysis;

    bool result(const Instruction &i, std::size_t k, const Enclosing *) const {
        const auto varies = [&](ValueId v) { return at(v); };
        return at(i.results[k]) || variesByItself(function, i) ||
               (isArrayAccess(i.op) && arrayOf(i)) || std::ranges::any_of(i.operands, varies);
    }
    /// A store of what is the same everywhere makes a difference, if it is not made everywhere.
    bool array(const Instruction &i, const Enclosing *around) const {
        if (i.op == Op::ArrayLoad || arrayOf(i))
            return arrayOf(i);
        for (; around; around = around->outer)
            if (const auto condition = conditionOf(*around->owner); condition && at(*condition))
                return true;
        return at(i, 0) || at(i, 1);
    }
    bool flow(const ValueFlow &flow, const Enclosing *) const {
        const auto condition = conditionOf(flow.owner);
        return at(flow.to) || (condition && at(*condition)) ||
               std::ranges::any_of(flow.from, [&](ValueId v) { return at(v); });
    }
    bool given(const Instruction &, std::size_t) const { return true; }
};

} // namespace

BoundVariation boundVariation(const Function &function) {
    Variation variation(function);
    solve(variation);
    BoundVariation result;
    for (const auto &cell : variation.values)
        result.value.push_back(cell.fact);
    for (const auto &cell : variation.arrays)
        result.array.push_back(cell.fact);
    return result;
}

} // namespace candela::ir
