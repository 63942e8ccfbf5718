// SPDX-License-Identifier: Apache-2.0
#include "language/ir/filter/reduction.h"

#include <map>
#include <set>

namespace candela::ir {

namespace {

/// Follows the ways from what a turn gives back to what it was given.
class Ways {
public:
    Ways(const ValueFacts &facts, ValueId before) : facts_(facts), before_(before) {}

    std::optional<Reduction> from(ValueId next) {
        used_[next] = 1;
        if (!reaches(next) || !kind_ || isTooDeep_)
            return {};
        for (const auto &[value, count] : used_)
            if (facts_.uses[value] != count)
                return {};
        return kind_;
    }

private:
    /// Long texts make long ways; beyond some length nothing is known, before the stack ends.
    struct Depth {
        explicit Depth(Ways &ways) : ways(ways) {
            constexpr int most = 2000;
            ways.isTooDeep_ |= ++ways.depth_ > most;
        }
        ~Depth() { --ways.depth_; }
        Ways &ways;
    };

    bool is(Reduction kind) {
        if (!kind_)
            kind_ = kind;
        return kind_ == kind;
    }

    /// One use of the value is on the way.
    bool use(ValueId v) {
        ++used_[v];
        return reaches(v);
    }
    bool reaches(ValueId v) {
        if (v == before_ || ends_.contains(v))
            return true; // Of a loop within: how it begins is looked at beside.
        const auto [known, isNew] = reaches_.try_emplace(v, false);
        if (!isNew)
            return known->second;
        const Depth depth(*this);
        const ValueFacts::Origin &origin = facts_.origin[v];
        const bool does = !isTooDeep_ && !origin.isArgument && origin.instruction &&
                          throughInstruction(*origin.instruction, origin.index);
        return reaches_[v] = does;
    }

    bool throughInstruction(const Instruction &i, std::size_t result) {
        switch (i.op) {
        case Op::Add: return is(Reduction::Sum) && throughEither(i);
        case Op::Sub: return leads(i.operands[0]) && is(Reduction::Sum) && use(i.operands[0]);
        case Op::Min: return is(Reduction::Least) && throughEither(i);
        case Op::Max: return is(Reduction::Greatest) && throughEither(i);
        case Op::Select: return throughComparison(i) || throughBoth(i.operands[1], i.operands[2]);
        case Op::If: return throughBoth(i.regions[0].yields[result], i.regions[1].yields[result]);
        case Op::Loop: return throughLoop(i, result);
        default: return false;
        }
    }

    /// Whether it depends on what was given, by any way at all.
    bool leads(ValueId v) {
        if (v == before_)
            return true;
        const auto [known, isNew] = leads_.try_emplace(v, false);
        if (!isNew)
            return known->second;
        const Depth depth(*this);
        const ValueFacts::Origin &origin = facts_.origin[v];
        if (!origin.instruction || isTooDeep_)
            return false;
        const Instruction &i = *origin.instruction;
        bool does = false;
        if (origin.isArgument) {
            does = i.op == Op::Loop && leads(i.operands[origin.index]);
        } else {
            for (const ValueId operand : i.operands)
                does |= leads(operand);
            for (const Region &region : i.regions)
                for (const ValueId yield : region.yields)
                    does |= leads(yield);
        }
        return leads_[v] = does;
    }
    bool throughEither(const Instruction &i) {
        for (const ValueId v : i.operands)
            if (leads(v))
                return use(v);
        return false;
    }
    bool throughBoth(ValueId a, ValueId b) {
        if (!leads(a) || !leads(b))
            return false;
        return use(a) && use(b);
    }

    /// if (e > m) m = e, and the three other ways to say it.
    bool throughComparison(const Instruction &i) {
        const Instruction *test = facts_.definition(i.operands[0]);
        if (!test || (test->op != Op::Less && test->op != Op::LessEqual))
            return false;
        const bool isSecond = leads(i.operands[2]), isFirst = leads(i.operands[1]);
        if (isSecond == isFirst)
            return false;
        const ValueId kept = i.operands[isSecond ? 2 : 1], taken = i.operands[isSecond ? 1 : 2];
        const ValueId smaller = test->operands[0], larger = test->operands[1];
        if (!((smaller == kept && larger == taken) || (smaller == taken && larger == kept)))
            return false;
        // Chosen where the test holds: the second operand of the Select.
        const bool givesLarger = i.operands[1] == larger;
        ++used_[kept]; // In the test.
        return is(givesLarger ? Reduction::Greatest : Reduction::Least) && use(kept);
    }

    /// A loop within the turn that adds and adds.
    bool throughLoop(const Instruction &loop, std::size_t result) {
        const Region &body = loop.regions[0];
        if (result == 0 || !leads(loop.operands[result]))
            return false;
        ends_.insert(body.arguments[result]);
        ++used_[body.yields[result]];
        return reaches(body.yields[result]) && use(loop.operands[result]);
    }

    const ValueFacts &facts_;
    const ValueId before_;
    std::optional<Reduction> kind_;
    std::map<ValueId, int> used_;
    std::map<ValueId, bool> reaches_, leads_;
    std::set<ValueId> ends_;
    int depth_ = 0;
    bool isTooDeep_ = false;
};

} // namespace

std::optional<Reduction> reductionOf(const ValueFacts &facts, ValueId before, ValueId next) {
    return Ways(facts, before).from(next);
}

} // namespace candela::ir
