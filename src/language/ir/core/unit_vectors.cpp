// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/unit_vectors.h"

namespace candela::ir {

void UnitVectors::note(Op op, const std::vector<ValueId> &operands, ValueId result) {
    if (op == Op::Neg || op == Op::Select)
        made_.emplace(result, Made{op, operands});
}

bool UnitVectors::has(const Vector &vector, int depth) const {
    if (normalized_.contains(vector))
        return true;
    const Made *made[3];
    for (int k = 0; k < 3; ++k) {
        const auto found = made_.find(vector[k]);
        if (found == made_.end())
            return false;
        made[k] = &found->second;
        if (made[k]->op != made[0]->op)
            return false;
    }
    if (depth == 0)
        return false;
    const auto operand = [&](std::size_t n) {
        return Vector{made[0]->operands[n], made[1]->operands[n], made[2]->operands[n]};
    };
    if (made[0]->op == Op::Neg)
        return has(operand(0), depth - 1);
    const Vector condition = operand(0);
    return condition[0] == condition[1] && condition[0] == condition[2] &&
           has(operand(1), depth - 1) && has(operand(2), depth - 1);
}

} // namespace candela::ir
