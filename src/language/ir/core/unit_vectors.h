// SPDX-License-Identifier: Apache-2.0
// Which vectors of a function under construction have unit length, so that nothing normalises them
// again.
#pragma once

#include "language/ir/core/ir.h"

#include <array>
#include <set>
#include <unordered_map>
#include <vector>

namespace candela::ir {

/// Vectors that normalize() has made, their opposites, and choices among such. They are as long as
/// rounding lets them be, or zero; those whose squared length is no normal float, which normalising
/// makes neither unit nor zero, stay as they are.
class UnitVectors {
public:
    using Vector = std::array<ValueId, 3>;

    void addNormalized(const Vector &vector) { normalized_.insert(vector); }
    /// Takes note of a choice or a negation; of other operations nothing.
    void note(Op, const std::vector<ValueId> &operands, ValueId result);
    bool has(const Vector &vector) const { return has(vector, deepest); }

private:
    static constexpr int deepest = 8; ///< Of choices among choices.

    bool has(const Vector &, int depth) const;

    struct Made {
        Op op;
        std::vector<ValueId> operands;
    };
    std::set<Vector> normalized_;
    std::unordered_map<ValueId, Made> made_;
};

} // namespace candela::ir
