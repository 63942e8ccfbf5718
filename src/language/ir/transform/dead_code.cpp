// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/dead_code.h"

#include "language/ir/core/builder_fold.h"
#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"

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
    void need(std::span<const ValueId> values) {
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

    /// What this marks within regions is seen by run()'s next round: a second one here would double
    /// with every loop around.
    bool mark(const Instruction &i) {
        bool kept = isKept(i);
        const auto follow = [&](const ValueFlow &flow) {
            if (live_[flow.to])
                need(flow.from);
        };
        if (!i.regions.empty()) {
            forEachFlowOut(i, follow);
            forEachFlowIn(i, follow);
        }
        for (const Region &region : i.regions)
            kept |= mark(region);
        if (kept)
            needFixed(i);
        return kept;
    }

    /// What the instruction needs whichever of its results are used.
    void needFixed(const Instruction &i) {
        if (i.regions.empty())
            need(i.operands);
        else if (i.op != Op::If)
            need(std::span(i.operands).first(fixedOperands(i)));
        if (const auto condition = i.regions.empty() ? std::nullopt : conditionOf(i))
            need(*condition);
        if (i.op == Op::ArrayLoad)
            needArray(i.immediate);
        if (i.op == Op::PixelLoop)
            for (int array : function_.pixelLoops[std::size_t(i.immediate)].arrays)
                needArray(array);
    }
    void needArray(int array) {
        if (!arrayLive_[array])
            arrayLive_[array] = changed_ = true;
    }

    /// Of regions' owners: whatever stands in the regions.
    bool isKept(const Instruction &i) const {
        if (i.op == Op::ArrayStore)
            return arrayLive_[i.immediate];
        return hasEffect(i.op) || anyLive(i.results);
    }

    bool carriedLive(const Instruction &i, std::size_t k) const {
        return live_[i.results[k]] || live_[argumentOf(i, k)];
    }

    /// True if the instruction stays.
    bool prune(Instruction &i) {
        if (i.regions.empty())
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

void removeAll(Op op, Region &region) {
    removeInstructions(region, [op](const Instruction &i) { return i.op == op; });
}

} // namespace candela::ir
