// SPDX-License-Identifier: Apache-2.0
#include "language/ir/filter/value_facts.h"

namespace candela::ir {

ValueFacts::ValueFacts(const Function &function)
    : origin(function.values.size()), uses(function.values.size()) {
    read(function.body, nullptr, 0, nullptr);
}

void ValueFacts::read(const Region &region, const Instruction *owner, int depth,
                      const Instruction *loop) {
    for (std::size_t k = 0; k < region.arguments.size(); ++k)
        origin[region.arguments[k]] = {owner, k, true, depth, loop};
    for (const Instruction &i : region.body) {
        for (std::size_t k = 0; k < i.results.size(); ++k)
            origin[i.results[k]] = {&i, k, false, depth, loop};
        for (ValueId v : i.operands)
            ++uses[v];
        const bool isLoop = i.op == Op::Loop;
        for (const Region &inner : i.regions)
            read(inner, &i, depth + isLoop, isLoop ? &i : loop);
    }
    for (ValueId v : region.yields)
        ++uses[v];
}

const float *ValueFacts::number(ValueId v) const {
    const Instruction *made = definition(v);
    return made && made->op == Op::ConstFloat ? &made->number : nullptr;
}

} // namespace candela::ir
