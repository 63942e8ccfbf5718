// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/dependence.h"

#include "language/ir/core/dataflow.h"

#include <algorithm>

namespace candela::ir {

namespace {

/// What a value needs; by control, too.
struct BindingTimeAnalysis : ForwardAnalysis<BindingTime> {
    using ForwardAnalysis::ForwardAnalysis;

    BindingTime latest(std::span<const ValueId> values,
                       BindingTime start = BindingTime::Surface) const {
        for (ValueId v : values)
            start = std::max(start, at(v));
        return start;
    }
    /// A spill slot holds a float; integers and strings that control flow chooses are chosen anew.
    bool canBeSaved(ValueId v) const {
        const Type type = function.values[v].type;
        return type == Type::Float || type == Type::Bool;
    }

    /// The latest condition that stands around; a light loop's is the light itself.
    BindingTime conditionAround(const Enclosing *around) const {
        BindingTime condition = BindingTime::Surface;
        for (; around; around = around->outer) {
            const auto decides = conditionOf(*around->owner);
            condition = std::max(condition, decides ? at(*decides) : BindingTime::Response);
        }
        return condition;
    }
    /// The latest value that a loop around carries.
    BindingTime carriedAround(const Enclosing *around) const {
        BindingTime carried = BindingTime::Surface;
        for (; around; around = around->outer)
            if (around->owner->op == Op::Loop)
                carried = latest(around->owner->regions[0].arguments, carried);
        return carried;
    }

    BindingTime result(const Instruction &i, std::size_t, const Enclosing *around) const {
        if (i.op == Op::Input)
            return bindingTimeOf(ShaderInput(i.immediate));
        if (isArrayAccess(i.op))
            return arrayOf(i);
        if (isService(i.op))
            return latest(i.operands, conditionAround(around));
        return isAnswer(i.op) ? BindingTime::Response : latest(i.operands);
    }
    /// Loads and stores of an array keep their order: all count to the latest.
    BindingTime array(const Instruction &i, const Enclosing *around) const {
        return std::max(
            {arrayOf(i), latest(i.operands, conditionAround(around)), carriedAround(around)});
    }
    BindingTime flow(const ValueFlow &flow, const Enclosing *around) const {
        const auto condition = conditionOf(flow.owner);
        if (!condition || !canBeSaved(flow.to))
            return BindingTime::Response;
        const BindingTime time = latest(flow.from, at(*condition));
        return flow.owner.op == Op::Loop ? std::max(time, conditionAround(around)) : time;
    }
    BindingTime given(const Instruction &, std::size_t) const { return BindingTime::Response; }
};

/// Notes who makes the request, and whether it stands apart from all answers.
void noteRequest(const BindingTimeAnalysis &times, const Instruction &i, const Enclosing *around,
                 Dependence &result) {
    result.request[i.immediate] = &i;
    const std::span<const ValueId> operands(i.operands);
    const BindingTime asked =
        times.latest(i.op == Op::LightLoop ? operands.subspan(3, fixedOperands(i) - 3) : operands);
    bool repeated = false;
    for (const Enclosing *owner = around; owner; owner = owner->outer)
        repeated |= owner->owner->op != Op::If;
    const bool isStatic = !repeated && asked < BindingTime::Response &&
                          times.conditionAround(around) < BindingTime::Response;
    if (!isStatic && result.staticRequests) {
        result.staticRequests = false;
        result.notStaticLine = i.line;
    }
}

} // namespace

Dependence analyzeDependence(const Function &function) {
    BindingTimeAnalysis times(function);
    solve(times);
    Dependence result;
    for (const auto &cell : times.values)
        result.bindingTime.push_back(cell.fact);
    for (const auto &cell : times.arrays)
        result.arrayBindingTime.push_back(cell.fact);
    result.definition.resize(function.values.size());
    result.request.assign(function.requests.size(), nullptr);
    forEachEnclosed(function.body, [&](const Instruction &i, const Enclosing *around) {
        for (std::size_t k = 0; k < i.results.size(); ++k)
            result.definition[i.results[k]] = {&i, int(k)};
        if (info(i.op).immediate == Immediate::Request)
            noteRequest(times, i, around, result);
    });
    return result;
}

} // namespace candela::ir
