// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/uniformity.h"

#include "language/ir/core/dataflow.h"

#include <algorithm>

namespace candela::ir {

namespace {

struct UniformityAnalysis : ForwardAnalysis<Uniformity> {
    using ForwardAnalysis::ForwardAnalysis;

    bool anyVaries(std::span<const ValueId> all) const {
        return std::any_of(all.begin(), all.end(),
                           [&](ValueId v) { return at(v) == Uniformity::Varying; });
    }
    static Uniformity varyingIf(bool varies) {
        return varies ? Uniformity::Varying : Uniformity::Uniform;
    }

    /// Whether lanes may disagree on what runs within the owner.
    bool diverges(const Instruction &owner) const {
        const auto condition = conditionOf(owner);
        return !condition || at(*condition) == Uniformity::Varying;
    }

    Uniformity result(const Instruction &i, std::size_t, const Enclosing *) const {
        switch (info(i.op).uniformity) {
        case ResultUniformity::Uniform: return Uniformity::Uniform;
        case ResultUniformity::Varying: return Uniformity::Varying;
        case ResultUniformity::Service:
            return varyingIf(variesByItself(serviceOf(function, i)) || anyVaries(i.operands));
        case ResultUniformity::Array:
            return varyingIf(arrayOf(i) == Uniformity::Varying || anyVaries(i.operands));
        default: return varyingIf(anyVaries(i.operands));
        }
    }
    Uniformity array(const Instruction &i, const Enclosing *around) const {
        if (!hasEffect(i.op))
            return arrayOf(i);
        bool divergent = false;
        for (; around; around = around->outer)
            divergent |= diverges(*around->owner);
        return varyingIf(divergent || arrayOf(i) == Uniformity::Varying || anyVaries(i.operands));
    }
    Uniformity flow(const ValueFlow &flow, const Enclosing *) const {
        return varyingIf(diverges(flow.owner) || anyVaries(flow.from));
    }
    Uniformity given(const Instruction &, std::size_t) const { return Uniformity::Varying; }
};

} // namespace

void inferUniformity(Function &function) {
    UniformityAnalysis uniformity(function, Uniformity::Uniform);
    solve(uniformity);
    for (std::size_t v = 0; v < function.values.size(); ++v)
        function.values[v].uniformity = uniformity.values[v].fact;
    for (std::size_t a = 0; a < function.arrays.size(); ++a)
        function.arrays[a].uniformity = uniformity.arrays[a].fact;
}

} // namespace candela::ir
