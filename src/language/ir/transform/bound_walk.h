// SPDX-License-Identifier: Apache-2.0
// Over a box: control flow and memory.
//
// Where all points of the box take the same way, the middle shows it, and forms go along with the
// values. Where they may part, both sides of an If run; what stands in the side that the middle
// does not take are the values that the middle would have there, and the result is in the union. A
// Loop turns as the middle turns; where others may turn more or less often, nothing is known of
// what it leaves, and, if it stores to arrays, of anything.
#pragma once

#include "language/ir/transform/bound_rules.h"
#include "language/ir/transform/bound_variation.h"

namespace candela::ir {

class BoundWalk {
public:
    /// The builder's function has the old one's tables, but no arrays and no code.
    BoundWalk(const Function &old, Builder &);

    /// Writes the region; outputs are left out.
    void walk(const Region &);

    /// What has become of a value of the old function.
    const BoundedValue &operator[](ValueId old) const { return written_[old]; }
    /// Whether nothing is known of anything; to be asked at the end.
    ValueId isLost();
    const std::vector<BoundlessNote> &notes() const { return rules_.notes(); }

private:
    /// Of an old array: its elements, and what stands beside them.
    struct Memory {
        int middle = -1;
        std::array<int, FormParts::count> form{};
        int unsure = -1;
    };
    /// Whether the middle comes to a place, and whether all points do; none: they do.
    struct Way {
        std::optional<ValueId> middle, all;
    };

    void walk(const Instruction &);
    void walkIf(const Instruction &);
    void walkLoop(const Instruction &);
    void skipLightLoop(const Instruction &);
    void walkLoad(const Instruction &);
    void walkStore(const Instruction &);

    Values take(const std::vector<ValueId> &old, const std::vector<ValueId> &like);
    std::vector<BoundedValue> give(const std::vector<ValueId> &like, const ValueId *now);
    ValueId nothingOf(Type);
    BoundedValue elementAt(int array, ValueId index);
    FormParts anyElement(int array, ValueId middle);
    void loseAll();

    const Function &old_;
    Builder &b_;
    BoundVariation variation_;
    BoundRules rules_;
    std::vector<BoundedValue> written_;
    std::vector<Memory> memory_;
    Way way_;
    int lost_ = -1; ///< An array of one bool.
};

} // namespace candela::ir
