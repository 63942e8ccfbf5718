// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/constant_pool.h"

#include "language/ir/core/op_info.h"

#include <bit>
#include <iterator>

namespace candela::ir {

ValueId ConstantPool::intern(Function &function, Op op, int immediate, float number) {
    auto [it, isNew] = known_.try_emplace({op, immediate, std::bit_cast<std::uint32_t>(number)});
    if (isNew) {
        ValueId v = it->second =
            function.addValue(typeOf(info(op).results[0]), Uniformity::Uniform);
        index_.resize(v + 1, -1);
        index_[v] = int(constants_.size());
        constants_.push_back({op, {}, {v}, {}, immediate, number, 0});
    }
    return it->second;
}

const Instruction *ConstantPool::find(ValueId v) const {
    int index = v < index_.size() ? index_[v] : -1;
    return index < 0 ? nullptr : &constants_[index];
}

void ConstantPool::moveTo(Function &function) {
    auto &body = function.body.body;
    body.insert(body.begin(), std::make_move_iterator(constants_.begin()),
                std::make_move_iterator(constants_.end()));
}

} // namespace candela::ir
