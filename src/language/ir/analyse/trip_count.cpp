// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/trip_count.h"

#include "language/ir/core/evaluate.h"
#include "language/ir/core/op_info.h"

namespace candela::ir {

namespace {

/// Evaluates what it can; forgets what it cannot.
class Evaluation {
public:
    explicit Evaluation(std::map<ValueId, Known> &known) : known_(known) {}

    void run(const Region &region) {
        for (const Instruction &i : region.body) {
            for (ValueId v : i.results)
                known_.erase(v);
            run(i);
        }
    }

private:
    std::optional<Known> get(ValueId v) const {
        auto it = known_.find(v);
        return it == known_.end() ? std::nullopt : std::optional(it->second);
    }

    void run(const Instruction &i) {
        if (i.op == Op::If)
            return runIf(i);
        if (i.op == Op::ConstFloat)
            known_[i.results[0]] = i.number;
        else if (i.op == Op::ConstBool)
            known_[i.results[0]] = i.immediate ? 1.0f : 0.0f;
        else if (i.results.size() == 1 && !i.operands.empty())
            runArithmetic(i);
    }

    void runIf(const Instruction &i) {
        auto condition = get(i.operands[0]);
        if (!condition)
            return;
        const Region &region = i.regions[*condition != 0 ? 0 : 1];
        run(region);
        for (std::size_t k = 0; k < i.results.size(); ++k)
            if (auto yielded = get(region.yields[k]))
                known_[i.results[k]] = *yielded;
    }

    void runArithmetic(const Instruction &i) {
        auto a = get(i.operands[0]);
        if (i.op == Op::Select && a)
            a = get(i.operands[*a != 0 ? 1 : 2]);
        else if (i.op == Op::Select)
            return;
        auto b = i.operands.size() > 1 && i.op != Op::Select ? get(i.operands[1]) : a;
        // One false operand decides And, one true one Or.
        if (i.op == Op::And && ((a && *a == 0) || (b && *b == 0)))
            known_[i.results[0]] = 0;
        if (i.op == Op::Or && ((a && *a != 0) || (b && *b != 0)))
            known_[i.results[0]] = 1;
        if (!a || !b)
            return;
        float &result = known_[i.results[0]];
        if (isFloatComparison(i.op))
            result = evaluateCompare(i.op, *a, *b);
        else if (isFloatArithmetic(i.op))
            result = evaluateFloat(i.op, *a, *b);
        else
            runLogic(i, *a, *b, result);
    }

    void runLogic(const Instruction &i, Known a, Known b, Known &result) {
        switch (i.op) {
        case Op::And: result = a != 0 && b != 0; break;
        case Op::Or: result = a != 0 || b != 0; break;
        case Op::Not: result = a == 0; break;
        case Op::Select:
        case Op::FloatFromBool: result = a; break;
        default: known_.erase(i.results[0]);
        }
    }

    std::map<ValueId, Known> &known_;
};

} // namespace

std::optional<int> tripCount(const Instruction &loop, std::map<ValueId, Known> known, int most) {
    const Region &region = loop.regions[0];
    auto copy = [&](const std::vector<ValueId> &from) {
        std::map<ValueId, Known> next;
        for (std::size_t k = 0; k < from.size(); ++k)
            if (auto it = known.find(from[k]); it != known.end())
                next[region.arguments[k]] = it->second;
        for (ValueId v : region.arguments)
            known.erase(v);
        known.insert(next.begin(), next.end());
    };
    copy(loop.operands);
    for (int turn = 0; turn <= most; ++turn) {
        auto condition = known.find(region.arguments[0]);
        if (condition == known.end())
            return {};
        if (condition->second == 0)
            return turn;
        Evaluation(known).run(region);
        copy(region.yields);
    }
    return {};
}

} // namespace candela::ir
