// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/dead_code.h"

#include "language/ir/core/builder_fold.h"
#include "language/ir/core/op_info.h"

#include <algorithm>

namespace candela::ir {

namespace {

/// Marks what is needed, backwards, until nothing more is marked; then prunes.
class DeadCode {
public:
    explicit DeadCode(Function &function)
        : function_(function), live_(function.values.size()), arrayLive_(function.arrays.size()) {}

    void run() {
        do {
            changed_ = false;
            mark(function_.body);
        } while (changed_);
        prune(function_.body);
        markInputsRead(function_);
    }

private:
    void need(ValueId v) {
        if (!live_[v])
            live_[v] = changed_ = true;
    }
    void need(const std::vector<ValueId> &values) {
        for (ValueId v : values)
            need(v);
    }
    bool anyLive(const std::vector<ValueId> &values) const {
        return std::any_of(values.begin(), values.end(), [&](ValueId v) { return live_[v]; });
    }

    /// True if the region holds anything that must stay.
    bool mark(const Region &region) {
        bool kept = false;
        for (auto i = region.body.rbegin(); i != region.body.rend(); ++i)
            kept |= mark(*i);
        return kept;
    }

    bool mark(const Instruction &i) {
        if (i.op == Op::If)
            return markIf(i);
        if (i.op == Op::Loop || i.op == Op::LightLoop)
            return markLoop(i);
        bool kept = isKept(i);
        if (kept) {
            need(i.operands);
            if (i.op == Op::ArrayLoad && !arrayLive_[i.immediate])
                arrayLive_[i.immediate] = changed_ = true;
        }
        return kept;
    }

    bool isKept(const Instruction &i) const {
        if (i.op == Op::ArrayStore)
            return arrayLive_[i.immediate];
        return hasEffect(i.op) || anyLive(i.results);
    }

    bool markIf(const Instruction &i) {
        bool kept = anyLive(i.results);
        for (const Region &region : i.regions) {
            for (std::size_t k = 0; k < i.results.size(); ++k)
                if (live_[i.results[k]])
                    need(region.yields[k]);
            kept |= mark(region);
        }
        if (kept)
            need(i.operands[0]);
        return kept;
    }

    /// Operands, results, yields and the last arguments of the region run in step. What this marks
    /// within the region is seen by run()'s next round: a second one here would double with every
    /// loop around.
    bool markLoop(const Instruction &i) {
        const Region &region = i.regions[0];
        bool kept = anyLive(i.results);
        std::size_t firstOperand = i.operands.size() - i.results.size();
        std::size_t firstArgument = region.arguments.size() - i.results.size();
        for (std::size_t k = 0; k < i.results.size(); ++k)
            if (carriedLive(i, k)) {
                need(region.yields[k]);
                need(i.operands[firstOperand + k]);
                need(region.arguments[firstArgument + k]);
            }
        kept |= mark(region);
        if (kept) {
            if (i.op == Op::Loop)
                need(region.arguments[0]);
            for (std::size_t k = 0; k < firstOperand; ++k)
                need(i.operands[k]);
        }
        return kept;
    }

    bool carriedLive(const Instruction &i, std::size_t k) const {
        const Region &region = i.regions[0];
        std::size_t firstArgument = region.arguments.size() - i.results.size();
        return live_[i.results[k]] || live_[region.arguments[firstArgument + k]];
    }

    /// True if the instruction stays.
    bool prune(Instruction &i) {
        if (i.op != Op::If && i.op != Op::Loop && i.op != Op::LightLoop)
            return isKept(i);
        bool loop = i.op != Op::If;
        bool kept = false;
        std::vector<bool> keep;
        for (std::size_t k = 0; k < i.results.size(); ++k) {
            keep.push_back(loop ? carriedLive(i, k) : live_[i.results[k]]);
            kept |= keep.back();
        }
        for (Region &region : i.regions) {
            prune(region);
            kept |= !region.body.empty();
            filter(region.yields, keep);
            if (loop)
                filter(region.arguments, keep);
        }
        filter(i.results, keep);
        if (loop)
            filter(i.operands, keep);
        return kept;
    }

    void prune(Region &region) {
        std::vector<Instruction> kept;
        for (Instruction &i : region.body)
            if (prune(i))
                kept.push_back(std::move(i));
        region.body = std::move(kept);
    }

    /// Of the last values, as many as `keep` has, leaves those that it says.
    static void filter(std::vector<ValueId> &values, const std::vector<bool> &keep) {
        std::size_t first = values.size() - keep.size();
        std::vector<ValueId> kept(values.begin(), values.begin() + first);
        for (std::size_t k = 0; k < keep.size(); ++k)
            if (keep[k])
                kept.push_back(values[first + k]);
        values = std::move(kept);
    }

    Function &function_;
    std::vector<bool> live_, arrayLive_;
    bool changed_ = false;
};

} // namespace

void removeDeadCode(Function &function) { DeadCode(function).run(); }

} // namespace candela::ir
