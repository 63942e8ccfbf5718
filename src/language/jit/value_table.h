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
    ir::Rate rate(ir::ValueId id) const { return function_.values[id].rate; }
    /// For a function that is compiled in pieces, before any value is set.
    void keepIn(SpillArea &spills) { spills_ = &spills; }
    /// Of a value's own rate.
    Value *get(ir::ValueId id) const {
        return spills_ ? spills_->here(id, values_[id]) : values_[id];
    }
    /// Of the rate that is wanted, if the value's own is not above it.
    Value *get(ir::ValueId id, ir::Rate wanted) const {
        return wanted == ir::Rate::Varying ? lanes_.splat(get(id)) : get(id);
    }
    Values get(const std::vector<ir::ValueId> &ids, ir::Rate wanted) const {
        Values result;
        for (ir::ValueId id : ids)
            result.push_back(get(id, wanted));
        return result;
    }
    void set(ir::ValueId id, Value *value) {
        values_[id] = rate(id) == ir::Rate::Varying ? lanes_.splat(value) : value;
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
