// SPDX-License-Identifier: Apache-2.0
// What a text's values and arrays become where it is specialised.
#pragma once

#include "language/ir/analyse/dependence.h"
#include "language/ir/core/builder.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace candela::ir {

/// The new values by assumption and old value. What an earlier binding time has computed is not
/// written anew but recomputed where that is cheap, else it comes from the frame.
class ValueMapping {
public:
    /// `slots` as SpecializationOptions has them.
    ValueMapping(const Function &text, const Dependence &, Builder &, int assumptions,
                 int recomputeCost, const std::map<ValueId, int> *slots);

    void assign(int assumption, ValueId old, ValueId now) { maps_[assumption][old] = now; }
    /// Nothing if it stands nowhere yet.
    std::optional<ValueId> known(int assumption, ValueId old) const;
    /// If need be from an earlier binding time.
    ValueId value(int assumption, ValueId old);
    Values values(int assumption, const Values &old);
    Triple triple(int assumption, const Triple &old);

    /// Stores the value in the frame if it has a slot there.
    void save(ValueId old, ValueId now);
    /// The new array. Those that respond to light differ by assumption.
    int array(int assumption, int old, int loopDepth);

private:
    ValueId rematerialise(int assumption, ValueId old);
    int cost(ValueId) const;

    const Function &text_;
    const Dependence &dependence_;
    Builder &b_;
    const int recomputeCost_;
    const std::map<ValueId, int> *slots_;
    std::vector<std::vector<ValueId>> maps_;
    std::map<std::pair<int, int>, int> arrays_; ///< By assumption (or -1) and old array.
};

} // namespace candela::ir
