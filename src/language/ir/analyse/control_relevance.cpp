// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/control_relevance.h"

#include "language/ir/core/op_info.h"

#include <set>

namespace candela::ir {

namespace {

/// Which parameters a value is a function of, if it is one of parameters and constants alone.
struct Origin {
    bool reached = false;
    bool other = false; ///< Something else goes into it.
    std::set<int> slots;
};

class ControlSweep {
public:
    explicit ControlSweep(const Function &function)
        : function_(function), origins_(function.values.size()) {
        do {
            changed_ = false;
            sweep(function.body);
        } while (changed_);
    }
    std::set<int> relevant_;

private:
    void add(ValueId v, const Origin &from) {
        Origin &known = origins_[v];
        std::size_t before = known.slots.size();
        known.slots.insert(from.slots.begin(), from.slots.end());
        if (known.slots.size() != before || (from.other && !known.other) ||
            (from.reached && !known.reached))
            changed_ = true;
        known.other |= from.other;
        known.reached |= from.reached;
    }

    void decide(ValueId v) {
        const Origin &origin = origins_[v];
        if (!origin.other)
            relevant_.insert(origin.slots.begin(), origin.slots.end());
    }

    void sweep(const Region &region) {
        for (const Instruction &i : region.body)
            sweep(i);
    }

    void sweep(const Instruction &i) {
        Origin from{true, false, {}};
        for (ValueId v : i.operands) {
            from.other |= origins_[v].other;
            from.slots.insert(origins_[v].slots.begin(), origins_[v].slots.end());
        }
        from.other |=
            info(i.op).varying || !isPure(i.op) || i.op == Op::Space || i.op == Op::SpaceInverse;
        if (i.op == Op::Parameter)
            from = {true, false, {i.immediate}};
        if (i.op == Op::If || i.op == Op::Loop || i.op == Op::LightLoop)
            return sweepControl(i);
        for (ValueId v : i.results)
            add(v, from);
    }

    void sweepControl(const Instruction &i) {
        const Region &first = i.regions[0];
        std::size_t fixed = i.operands.size() - i.results.size();
        if (i.op == Op::LightLoop)
            for (ValueId v : first.arguments)
                add(v, {true, true, {}});
        for (std::size_t k = 0; k < i.results.size() && i.op == Op::Loop; ++k) {
            add(first.arguments[k], origins_[i.operands[fixed + k]]);
            add(first.arguments[k], origins_[first.yields[k]]);
            add(first.arguments[k], origins_[first.arguments[0]]);
        }
        for (const Region &region : i.regions)
            sweep(region);
        for (std::size_t k = 0; k < i.results.size(); ++k) {
            if (i.op == Op::If)
                add(i.results[k], origins_[i.operands[0]]);
            for (const Region &region : i.regions)
                add(i.results[k], origins_[region.yields[k]]);
            if (i.op != Op::If)
                add(i.results[k], origins_[i.operands[fixed + k]]);
        }
    }

public:
    /// Once the origins are settled: what decides control flow.
    void collect(const Region &region) {
        for (const Instruction &i : region.body) {
            if (i.op == Op::If || i.op == Op::ArrayLoad || i.op == Op::ArrayStore)
                decide(i.operands[0]);
            if (i.op == Op::Loop)
                decide(i.regions[0].arguments[0]);
            bool angled =
                i.op == Op::LightLoop && function_.requests[i.immediate].form == ConeForm::Extended;
            if (angled && function_.requests[i.immediate].coneCount > 0)
                decide(i.operands[6]);
            for (const Region &inner : i.regions)
                collect(inner);
        }
    }

private:
    const Function &function_;
    std::vector<Origin> origins_;
    bool changed_ = false;
};

} // namespace

std::vector<int> controlRelevantParameters(const Function &whole) {
    ControlSweep sweep(whole);
    sweep.collect(whole.body);
    return {sweep.relevant_.begin(), sweep.relevant_.end()};
}

} // namespace candela::ir
