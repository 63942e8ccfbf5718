// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/op_info.h"

#include "language/runtime/runtime_functions.h"

namespace candela::ir {

int costOf(const Function &function, const Instruction &i) {
    if (i.op == Op::Call)
        return runtime::info(runtime::RuntimeFunction(i.immediate)).cost;
    return isService(i.op) ? serviceOf(function, i).info->cost : info(i.op).cost;
}

} // namespace candela::ir
