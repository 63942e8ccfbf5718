// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/control_relevance.h"

#include "language/ir/core/dataflow.h"

#include <set>

namespace candela::ir {

namespace {

/// A value of more parameters is as good as one of something else: sets would grow with the square
/// of their number.
constexpr std::size_t mostSlots = 64;

/// Which parameters a value is a function of, if it is one of parameters and constants alone.
struct Origin {
    bool other = false; ///< Something else goes into it.
    std::set<int> slots;

    void add(const Origin &from) {
        if (!other && !from.other)
            slots.insert(from.slots.begin(), from.slots.end());
        other |= from.other || slots.size() > mostSlots;
        if (other)
            slots.clear();
    }
    friend bool operator==(const Origin &, const Origin &) = default;
};

struct OriginAnalysis : ForwardAnalysis<Origin> {
    using ForwardAnalysis::ForwardAnalysis;

    Origin result(const Instruction &i, std::size_t, const Enclosing *) const {
        if (i.op == Op::Parameter)
            return {false, {i.immediate}};
        Origin from;
        from.other = info(i.op).uniformity == ResultUniformity::Varying || !isPure(i.op) ||
                     info(i.op).kind == OpClass::Source || info(i.op).kind == OpClass::Service;
        for (ValueId v : i.operands)
            from.add(at(v));
        return from;
    }
    Origin array(const Instruction &, const Enclosing *) const { return {}; }
    Origin flow(const ValueFlow &flow, const Enclosing *) const {
        Origin from;
        for (ValueId v : flow.from)
            from.add(at(v));
        if (const auto condition = conditionOf(flow.owner))
            from.add(at(*condition));
        return from;
    }
    Origin given(const Instruction &, std::size_t) const { return {true, {}}; }
};

/// What decides control flow at the instruction: branches, trip counts, indices, and whether an
/// extended loop's cone is a direction.
std::optional<ValueId> decisionOf(const Function &function, const Instruction &i) {
    if (isArrayAccess(i.op))
        return i.operands[0];
    if (i.op != Op::LightLoop)
        return i.regions.empty() ? std::nullopt : conditionOf(i);
    const LightRequest &request = function.requests[i.immediate];
    const bool angled = request.form == ConeForm::Extended && request.coneCount > 0;
    return angled ? std::optional(i.operands[6]) : std::nullopt;
}

} // namespace

std::vector<int> controlRelevantParameters(const Function &whole) {
    OriginAnalysis origins(whole);
    solve(origins);
    std::set<int> relevant;
    forEachInstruction(whole.body, [&](const Instruction &i) {
        if (const auto decision = decisionOf(whole, i); decision && !origins.at(*decision).other)
            relevant.insert(origins.at(*decision).slots.begin(), origins.at(*decision).slots.end());
    });
    return {relevant.begin(), relevant.end()};
}

} // namespace candela::ir
