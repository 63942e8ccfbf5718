// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/bounds.h"

#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/transform/bound_walk.h"
#include "language/ir/transform/dead_code.h"
#include "language/ir/transform/specialize.h"

#include <algorithm>
#include <limits>

namespace candela::ir {

namespace {

/// From the middle to a side: the slope; 0 of a box without extent.
ValueId slopeOf(Builder &b, ValueId along, ShaderInput extent) {
    const ValueId D = input(b, extent), zero = number(b, 0);
    const ValueId isEmpty = equal(b, D, zero);
    const ValueId slope = div(b, along, mul(b, number(b, 0.5f), D));
    return select(b, isEmpty, zero, slope);
}

void writeBound(Builder &b, const BoundOutputs &to, int component, const BoundedValue &v,
                ValueId isLost) {
    const FormParts f = formOf(b, v);
    output(b, to.value, component, v.middle);
    output(b, to.byU, component, slopeOf(b, f.alongU, ShaderInput::Du));
    output(b, to.byV, component, slopeOf(b, f.alongV, ShaderInput::Dv));
    // The slopes and what is made of them are rounded.
    const auto size = [&](ValueId x) { return unary(b, Op::Abs, x); };
    const ValueId spread = add(b, size(f.alongU), size(f.alongV));
    const ValueId off = add(b, f.off, mul(b, spread, number(b, 0x1p-21f)));
    const float endless = std::numeric_limits<float>::infinity();
    output(b, to.tolerance, component, select(b, isLost, number(b, endless), off));
}

/// Nothing is known of any.
Function withoutBounds(const Function &function, const std::vector<BoundOutputs> &list) {
    Function result = function;
    const float endless = std::numeric_limits<float>::infinity();
    const auto constant = [&](float x) {
        const ValueId v = result.addValue(Type::Float, Uniformity::Uniform);
        Instruction i{.op = Op::ConstFloat, .operands = {}, .results = {v}, .regions = {}};
        i.number = x;
        result.body.body.push_back(std::move(i));
        return v;
    };
    const ValueId zero = constant(0), all = constant(endless);
    const auto write = [&](const OutputName &name, int component, ValueId v) {
        Instruction i{.op = Op::Output, .operands = {v}, .results = {}, .regions = {}};
        i.immediate = std::int32_t(result.outputs.size());
        result.outputs.push_back(outputSlot(name, component));
        result.body.body.push_back(std::move(i));
    };
    for (const OutputSlot &slot : function.outputs)
        for (const BoundOutputs &to : list)
            if (slot.name == OutputName(to.value)) {
                write(to.byU, slot.component, zero);
                write(to.byV, slot.component, zero);
                write(to.tolerance, slot.component, all);
            }
    return result;
}

} // namespace

Function withBounds(const Function &function, const std::vector<BoundOutputs> &list,
                    BoundReport &report) {
    Function result = emptyLike(function);
    Builder b(result, Budget(mostBoundInstructions));
    BoundWalk walk(function, b);
    walk.walk(function.body);
    const ValueId isLost = walk.isLost();
    for (const Instruction &i : function.body.body) {
        if (i.op != Op::Output)
            continue;
        const OutputSlot &slot = function.outputs[std::size_t(i.immediate)];
        const BoundedValue &value = walk[i.operands[0]];
        const auto to = std::ranges::find(
            list, slot.name, [](const BoundOutputs &outputs) { return OutputName(outputs.value); });
        if (to == list.end())
            output(b, slot.name, slot.component, value.middle);
        else
            writeBound(b, *to, slot.component, value, isLost);
    }
    b.finish();
    report.boundless = walk.notes();
    report.isTooLarge = b.budget().exceeded();
    if (report.isTooLarge)
        return withoutBounds(function, list);
    removeDeadCode(result);
    return result;
}

} // namespace candela::ir
