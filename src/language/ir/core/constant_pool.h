// SPDX-License-Identifier: Apache-2.0
// The constants of a function that is being built, each once, wherever it is first asked for.
#pragma once

#include "language/ir/core/ir.h"

#include <map>
#include <tuple>
#include <vector>

namespace candela::ir {

class ConstantPool {
public:
    /// The value of a constant operation; the function gets it if it has none yet.
    ValueId intern(Function &, Op, int immediate, float number);
    /// The instruction that defines the value if it is a constant, else null.
    const Instruction *find(ValueId) const;
    /// Puts all of them at the head of the function's body, once nothing more is asked for.
    void moveTo(Function &);

private:
    using Key = std::tuple<Op, int, std::uint32_t>;

    std::vector<Instruction> constants_;
    std::map<Key, ValueId> known_;
    std::vector<int> index_; ///< By value: index into constants_, -1 = not constant.
};

} // namespace candela::ir
