// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/late_loads.h"

#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"

#include <algorithm>
#include <utility>

namespace candela::ir {

namespace {

bool leavesSomething(const Instruction &i) {
    const auto leaves = [](const Instruction &one) {
        return hasEffect(one.op) && !isArrayAccess(one.op);
    };
    return leaves(i) || std::any_of(i.regions.begin(), i.regions.end(), [&](const Region &inner) {
               return anyInstruction(inner, leaves);
           });
}

/// What is read from planes.
bool isLoad(Op op) {
    const OpInfo &facts = info(op);
    return facts.purity == Purity::Pure &&
           (facts.immediate == Immediate::Input || facts.immediate == Immediate::Variable ||
            facts.immediate == Immediate::Frame || isAnswer(op));
}
bool isParameter(Op op) { return info(op).immediate == Immediate::Parameter; }

/// Code gathers this many parameters at the head of each block of points; more of them wait in
/// memory, and are loaded where they are used as all else.
constexpr std::size_t mostAtHead = 64;

/// Operations upon loads that may wait with them.
constexpr int mostHeight = 2;

/// Writes a body anew, what can wait before the first instruction that wants it.
class LateLoads {
public:
    LateLoads(std::size_t values, bool parametersWait)
        : waiting_(values, none), height_(values, mostHeight), parametersWait_(parametersWait) {}

    std::vector<Instruction> run(std::vector<Instruction> body) {
        result_.reserve(body.size());
        for (Instruction &i : body) {
            if (const int height = heightOf(i); height <= mostHeight) {
                wait(std::move(i), height);
                continue;
            }
            placeWhatIsUsed(i);
            if (leavesSomething(i))
                placeAll();
            if (isConstant(i.op) || isParameter(i.op))
                height_[i.results[0]] = 0;
            result_.push_back(std::move(i));
        }
        placeAll();
        return std::move(result_);
    }

private:
    static constexpr std::size_t none = std::size_t(-1);

    /// Above mostHeight where it can't wait.
    int heightOf(const Instruction &i) const {
        if ((isLoad(i.op) && i.operands.empty()) || (parametersWait_ && isParameter(i.op)))
            return 0;
        int height = mostHeight + 1;
        if (isPure(i.op) && info(i.op).speculation == Speculation::Always)
            for (ValueId v : i.operands)
                if (waiting_[v] != none)
                    height = 1;
        for (ValueId v : i.operands)
            height = std::max(height, height_[v] + 1);
        return height;
    }
    void wait(Instruction i, int height) {
        for (ValueId v : i.results) {
            waiting_[v] = late_.size();
            height_[v] = height;
        }
        late_.push_back(std::move(i));
    }
    void place(ValueId v) {
        const std::size_t which = std::exchange(waiting_[v], none);
        if (which == none)
            return;
        Instruction now = std::exchange(late_[which], {});
        for (ValueId own : now.results) {
            waiting_[own] = none;
            height_[own] = mostHeight;
        }
        placeWhatIsUsed(now);
        result_.push_back(std::move(now));
    }
    void placeWhatIsUsed(const Instruction &i) {
        for (ValueId v : i.operands)
            place(v);
        for (const Region &inner : i.regions) {
            for (const Instruction &each : inner.body)
                placeWhatIsUsed(each);
            for (ValueId v : inner.yields)
                place(v);
        }
    }
    void placeAll() {
        for (; placed_ < late_.size(); ++placed_)
            if (!late_[placed_].results.empty())
                place(late_[placed_].results[0]);
    }

    std::vector<std::size_t> waiting_; ///< By value: where in late_ it is, if it has no place yet.
    std::vector<int> height_;          ///< By value; mostHeight where it has a place, but
                                       ///< 0 where it is there anyway.
    bool parametersWait_;
    std::vector<Instruction> late_; ///< Those that have a place are empty.
    std::size_t placed_ = 0;        ///< Of late_, all of the first.
    std::vector<Instruction> result_;
};

} // namespace

void loadLate(Function &function) {
    const auto parameters = std::ranges::count_if(
        function.body.body, [](const Instruction &i) { return isParameter(i.op); });
    function.body.body = LateLoads(function.values.size(), std::size_t(parameters) > mostAtHead)
                             .run(std::move(function.body.body));
}

} // namespace candela::ir
