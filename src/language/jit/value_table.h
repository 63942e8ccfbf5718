// SPDX-License-Identifier: Apache-2.0
// The LLVM values of the IR's values.
#pragma once

#include "language/jit/code_function.h"

namespace candela::codegen {

class ValueTable {
public:
    ValueTable(const ir::Function &function, const Lanes &lanes)
        : function_(function), lanes_(lanes), values_(function.values.size()) {}

    const ir::Function &function() const { return function_; }
    ir::Rate rate(ir::ValueId id) const { return function_.values[id].rate; }
    /// Of a value's own rate.
    Value *get(ir::ValueId id) const { return values_[id]; }
    /// Of the rate that is wanted, if the value's own is not above it.
    Value *get(ir::ValueId id, ir::Rate wanted) const {
        return wanted == ir::Rate::Varying ? lanes_.splat(values_[id]) : values_[id];
    }
    Values get(const std::vector<ir::ValueId> &ids, ir::Rate wanted) const {
        Values result;
        for (ir::ValueId id : ids)
            result.push_back(get(id, wanted));
        return result;
    }
    void set(ir::ValueId id, Value *value) {
        values_[id] = rate(id) == ir::Rate::Varying ? lanes_.splat(value) : value;
    }

private:
    const ir::Function &function_;
    const Lanes &lanes_;
    Values values_; ///< By ValueId.
};

} // namespace candela::codegen
