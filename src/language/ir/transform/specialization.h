// SPDX-License-Identifier: Apache-2.0
// A text that is being specialised: what the walks over its control flow, its loops and its light
// share.
#pragma once

#include "language/ir/transform/specialize.h"

namespace candela::ir {

struct BindingTimes {
    BindingTime first, last;
    bool has(BindingTime s) const { return first <= s && s <= last; }
};

struct Specialization {
    Specialization(const Function &text, const Dependence &, Builder &,
                   const std::vector<Assumption> &, const SpecializationOptions &);

    const Function &text;
    const Dependence &dependence;
    Builder &b;
    const std::vector<Assumption> &assumptions;
    const SpecializationOptions &options;
    ValueMapping mapping;
    std::map<std::pair<OutputName, int>, ValueId> outputs; ///< As SpecializedText has them.
    std::vector<int> active; ///< The assumptions under which is being written; all at first.
    int loopDepth = 0;
    int repeating = 0; ///< > 0: what is being written was written, and saved, before.
    int ahead = 0;     ///< > 0: what is being written stands before the conditions around it.

    /// The binding time that a value of a binding time counts to.
    BindingTime counted(BindingTime) const;
    BindingTime bindingTimeOf(ValueId v) const { return counted(dependence.bindingTime[v]); }

    /// A value is the same under all active assumptions; it is saved where a frame wants it.
    void assignShared(ValueId old, ValueId now);

    /// Does what has to be written under these of the active assumptions alone.
    template <typename Work> void under(std::vector<int> assumptions, Work work) {
        std::swap(active, assumptions);
        work();
        std::swap(active, assumptions);
    }
};

/// Write what belongs to the range of binding times.
void walk(Specialization &, const Region &, BindingTimes);
/// The same where the region's owner has not been reached yet: values only.
void walkAhead(Specialization &, const Region &, BindingTimes);
void walkLoop(Specialization &, const Instruction &, BindingTimes);
void walkLightLoop(Specialization &, const Instruction &, BindingTimes);
/// Its results in a uniform field, for assumption `h` (uniform_field.cpp).
Values fieldLoop(Specialization &, int h, const Instruction &);
/// What a lobe sends on of light from everywhere, where its peak is 1.
ValueId energyOf(Specialization &, int h, const Cone &);
/// Answer, Ambient, Irradiance.
void walkAnswer(Specialization &, const Instruction &, BindingTimes);

} // namespace candela::ir
