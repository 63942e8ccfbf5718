// SPDX-License-Identifier: Apache-2.0
// What several operations of a text mean together: how built-ins and habits of shaders look once
// they are lowered.
#pragma once

#include "language/ir/core/ir.h"

#include <array>
#include <optional>
#include <vector>

namespace candela::ir {

class Idioms {
public:
    /// Of a function that outlives it and stays as it is.
    explicit Idioms(const Function &);

    /// What makes the value; null for arguments of regions.
    const Instruction *definition(ValueId v) const { return definitions_[v]; }
    /// The same if it is that operation; else null.
    const Instruction *definition(ValueId, Op) const;
    bool isNumber(ValueId, float) const;

    /// A vector and its length.
    struct Scaled {
        std::array<ValueId, 3> vector;
        ValueId length;
    };
    /// The vector whose components normalize() multiplies by this reciprocal of its length.
    std::optional<Scaled> scaledBy(ValueId reciprocal) const;

    /// from (1 - share) + to share; nothing stands for 1.
    struct Mix {
        std::optional<ValueId> from, to;
        ValueId share;
    };
    std::optional<Mix> mixOf(const Instruction &sum) const;

    /// The two vectors of a dot product, which ends with the sum.
    std::optional<std::array<std::array<ValueId, 3>, 2>> dotOf(const Instruction &sum) const;
    /// The other summand of a sum, which is left when one is taken off it.
    std::optional<ValueId> summandBeside(ValueId sum, ValueId one) const;
    /// The t of a smoothstep() that the Select is; nothing if it is none.
    std::optional<ValueId> smoothStepOf(const Instruction &) const;

private:
    std::vector<const Instruction *> definitions_; ///< By value.
};

} // namespace candela::ir
