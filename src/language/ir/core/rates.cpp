// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/rates.h"

#include "language/ir/core/dataflow.h"

#include <algorithm>

namespace candela::ir {

namespace {

struct RateAnalysis : ForwardAnalysis<Rate> {
    using ForwardAnalysis::ForwardAnalysis;

    bool anyVaries(std::span<const ValueId> all) const {
        return std::any_of(all.begin(), all.end(),
                           [&](ValueId v) { return at(v) == Rate::Varying; });
    }
    static Rate varyingIf(bool varies) { return varies ? Rate::Varying : Rate::Uniform; }

    /// Whether lanes may disagree on what runs within the owner.
    bool diverges(const Instruction &owner) const {
        const auto condition = conditionOf(owner);
        return !condition || at(*condition) == Rate::Varying;
    }

    Rate result(const Instruction &i, std::size_t, const Enclosing *) const {
        switch (info(i.op).uniformity) {
        case ResultUniformity::Uniform: return Rate::Uniform;
        case ResultUniformity::Varying: return Rate::Varying;
        case ResultUniformity::Array:
            return varyingIf(arrayOf(i) == Rate::Varying || anyVaries(i.operands));
        default: return varyingIf(anyVaries(i.operands));
        }
    }
    Rate array(const Instruction &i, const Enclosing *around) const {
        if (!hasEffect(i.op))
            return arrayOf(i);
        bool divergent = false;
        for (; around; around = around->outer)
            divergent |= diverges(*around->owner);
        return varyingIf(divergent || arrayOf(i) == Rate::Varying || anyVaries(i.operands));
    }
    Rate flow(const ValueFlow &flow, const Enclosing *) const {
        return varyingIf(diverges(flow.owner) || anyVaries(flow.from));
    }
    Rate given(const Instruction &, std::size_t) const { return Rate::Varying; }
};

} // namespace

void inferRates(Function &function) {
    RateAnalysis rates(function, Rate::Uniform);
    solve(rates);
    for (std::size_t v = 0; v < function.values.size(); ++v)
        function.values[v].rate = rates.values[v].fact;
    for (std::size_t a = 0; a < function.arrays.size(); ++a)
        function.arrays[a].rate = rates.arrays[a].fact;
}

} // namespace candela::ir
