// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/op_info.h"

#include "language/runtime/runtime_functions.h"

namespace candela::ir {

int costOf(const Instruction &i) {
    return i.op == Op::Call ? runtime::info(runtime::RuntimeFunction(i.immediate)).cost
                            : info(i.op).cost;
}

} // namespace candela::ir
