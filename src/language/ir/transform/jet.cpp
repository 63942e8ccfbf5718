// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/jet.h"

#include "language/ir/core/builder.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/regions.h"
#include "language/ir/transform/dead_code.h"
#include "language/ir/transform/jet_demand.h"
#include "language/ir/transform/jet_rules.h"

namespace candela::ir {

namespace {

/// All but the code.
Function tablesOf(const Function &function) {
    Function result = function;
    result.body = {};
    result.values.clear();
    return result;
}

int addedSlot(Function &function, const OutputName &name, int component) {
    const int known = slotOf(function.outputs, name, component);
    if (known >= 0)
        return known;
    function.outputs.push_back(outputSlot(name, component));
    return int(function.outputs.size()) - 1;
}

/// Adds the instructions that differentiate what an Output writes.
void addSlopes(Function &function, const Instruction &output, Direction d,
               std::vector<Instruction> &body) {
    const OutputSlot of = function.outputs[size_t(output.immediate)];
    Instruction slope{.op = Op::Slope, .operands = output.operands, .results = {}, .regions = {}};
    slope.results = {function.addValue(Type::Float, Uniformity::Varying)};
    slope.immediate = int(d);
    slope.line = output.line;
    Instruction write{.op = Op::Output, .operands = slope.results, .results = {}, .regions = {}};
    write.immediate =
        addedSlot(function, "d" + of.name.text() + (d == Direction::U ? "du" : "dv"), of.component);
    write.line = output.line;
    body.push_back(std::move(slope));
    body.push_back(std::move(write));
}

} // namespace

SlopeReport expandSlopes(Function &function, int mostValues) {
    if (!anyInstruction(function.body, [](const Instruction &i) { return i.op == Op::Slope; }))
        return {};
    Function old = function;
    removeDeadCode(old);
    JetDemand demand = jetDemand(old);
    if (demand.report.fault)
        return demand.report;
    Function written = tablesOf(old);
    Builder b(written);
    JetRules rules(std::move(demand.ofValue), std::move(demand.ofArray),
                   int(old.values.size()) + mostValues);
    writeWithCompanions(old, b, rules);
    b.finish();
    demand.report.fault = rules.fault();
    if (!demand.report.fault)
        function = std::move(written);
    return demand.report;
}

SlopeReport addOutputSlopes(Function &function, const std::vector<Direction> &directions,
                            int mostValues, const std::function<bool(const OutputName &)> &of) {
    Function extended = function;
    std::vector<Instruction> body;
    for (Instruction &i : extended.body.body) {
        body.push_back(std::move(i));
        const Instruction last = body.back();
        if (last.op == Op::Output && (!of || of(function.outputs[size_t(last.immediate)].name)))
            for (Direction d : directions)
                addSlopes(extended, last, d, body);
    }
    extended.body.body = std::move(body);
    const SlopeReport report = expandSlopes(extended, mostValues);
    if (!report.fault) {
        removeDeadCode(extended);
        function = std::move(extended);
    }
    return report;
}

} // namespace candela::ir
