// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/zero.h"

#include "language/ir/core/dataflow.h"
#include "language/ir/core/evaluate.h"

#include <algorithm>

namespace candela::ir {

namespace {

/// Optimistic: everything is zero until something shows otherwise.
struct ZeroAnalysis : ForwardAnalysis<bool> {
    using ForwardAnalysis::ForwardAnalysis;

    bool result(const Instruction &i, std::size_t, const Enclosing *) const {
        if (i.op == Op::ConstFloat)
            return i.number == 0;
        if (i.op == Op::ArrayLoad)
            return arrayOf(i);
        switch (info(i.op).slope) {
        case SlopeRule::Product: return at(i, 0) || at(i, 1);
        case SlopeRule::Quotient: return at(i, 0);
        case SlopeRule::Sum:
        case SlopeRule::Difference:
        case SlopeRule::Least:
        case SlopeRule::Greatest: return at(i, 0) && at(i, 1);
        case SlopeRule::Choice: return at(i, 1) && at(i, 2);
        default: return keepsZero(i) && at(i, 0);
        }
    }
    /// Of one number, 0 at 0.
    static bool keepsZero(const Instruction &i) {
        return isFloatArithmetic(i.op) && i.operands.size() == 1 && evaluateFloat(i.op, 0, 0) == 0;
    }

    bool array(const Instruction &i, const Enclosing *) const {
        return arrayOf(i) && (!hasEffect(i.op) || at(i, 1));
    }
    bool flow(const ValueFlow &flow, const Enclosing *) const {
        return std::all_of(flow.from.begin(), flow.from.end(), [&](ValueId v) { return at(v); });
    }
    bool given(const Instruction &, std::size_t) const { return false; }
};

} // namespace

std::vector<bool> provablyZero(const Function &function) {
    ZeroAnalysis zero(function, true);
    std::vector<bool> result;
    for (const auto &cell : solve(zero).values)
        result.push_back(cell.fact);
    return result;
}

} // namespace candela::ir
