// SPDX-License-Identifier: Apache-2.0
// The LLVM values of the IR's values.
#pragma once

#include "language/jit/spill_area.h"

namespace candela::codegen {

class ValueTable {
public:
    ValueTable(const ir::Function &function, const Lanes &lanes)
        : function_(function), lanes_(lanes), values_(function.values.size()) {}

    const ir::Function &function() const { return function_; }
    ir::Uniformity uniformity(ir::ValueId id) const { return function_.values[id].uniformity; }
    /// For a function of which values have slots, before any value is set.
    void keepIn(SpillArea &spills) { spills_ = &spills; }
    /// Null if nothing has a slot.
    const SpillArea *spills() const { return spills_; }
    /// As uniform as the value is.
    Value *get(ir::ValueId id) const {
        return spills_ ? spills_->here(id, values_[id]) : values_[id];
    }
    /// As it was made, maybe in another machine function; null if it is a parameter in memory.
    Value *made(ir::ValueId id) const { return values_[id]; }
    /// As is wanted: a varying one cannot be had as uniform.
    Value *get(ir::ValueId id, ir::Uniformity wanted) const {
        return wanted == ir::Uniformity::Varying ? lanes_.splat(get(id)) : get(id);
    }
    Values get(const std::vector<ir::ValueId> &ids, ir::Uniformity wanted) const {
        Values result;
        for (ir::ValueId id : ids)
            result.push_back(get(id, wanted));
        return result;
    }
    void set(ir::ValueId id, Value *value) {
        values_[id] = uniformity(id) == ir::Uniformity::Varying ? lanes_.splat(value) : value;
        if (spills_)
            spills_->save(id, values_[id]);
    }

private:
    const ir::Function &function_;
    const Lanes &lanes_;
    SpillArea *spills_ = nullptr;
    Values values_; ///< By ValueId.
};

} // namespace candela::codegen
