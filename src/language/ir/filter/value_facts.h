// SPDX-License-Identifier: Apache-2.0
// Where each value of a function comes from, and how often it is used.
#pragma once

#include "language/ir/core/ir.h"

namespace candela::ir {

struct ValueFacts {
    explicit ValueFacts(const Function &);

    /// Where a value is made.
    struct Origin {
        const Instruction *instruction = nullptr; ///< Whose result, or whose region's argument.
        std::size_t index = 0;                    ///< Among results or arguments.
        bool isArgument = false;
        /// The loops that it stands in, an argument its own among them: how many, and the
        /// innermost.
        int depth = 0;
        const Instruction *loop = nullptr;
    };

    /// The instruction whose plain result it is; null for arguments.
    const Instruction *definition(ValueId v) const {
        return origin[v].isArgument ? nullptr : origin[v].instruction;
    }
    /// The value of a constant.
    const float *number(ValueId v) const;

    std::vector<Origin> origin;
    std::vector<int> uses; ///< As operands and as what regions yield.

private:
    void read(const Region &, const Instruction *owner, int depth, const Instruction *loop);
};

} // namespace candela::ir
